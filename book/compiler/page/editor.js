// What a page has once somebody presses Edit.
import { editExercise } from './exercise-editor.js';
import { editFigure } from './figure-editor.js';
import { editFilm } from './film-editor.js';
import { tryHeader } from './try-editor.js';

globalThis.Editing = { exercise: editExercise, figure: editFigure, film: editFilm, header: tryHeader };
