// The files of the project's own sources, below a folder, as `room/path`.
import { readdirSync } from 'node:fs';
import { join } from 'node:path';

export const sourceFiles = source =>
  ['code', 'chapters', 'exercises', 'tests', 'book']
    .flatMap(room => readdirSync(join(source, room), { recursive: true }).map(name => `${room}/${name}`))
    .sort();
