// What a page has once somebody presses Edit.
import { editFigure } from './figure-editor.js';

globalThis.Editing = { figure: editFigure };
