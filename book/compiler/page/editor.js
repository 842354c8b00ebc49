// What a page has once somebody presses Edit.
import { editFigure } from './figure-editor.js';
import { editFilm } from './film-editor.js';

globalThis.Editing = { figure: editFigure, film: editFilm };
