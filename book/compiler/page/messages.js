// What Clang says, as messages with their lines.

/** @returns [{ line, column, kind, text }, ...] of the file: "lines:3:13: error: use of undeclared identifier 'b'" */
export const messagesOf = (said, file) =>
  said
    .split('\n')
    .map(
      row =>
        row.match(/^(?<file>[^\s:]+):(?<line>\d+):(?<column>\d+): (?<kind>error|fatal error|warning): (?<text>.*)$/)
          ?.groups,
    )
    .filter(found => found?.file.replace(/^\.\//, '') === file)
    .map(({ line, column, kind, text }) => ({
      line: Number(line),
      column: Number(column),
      kind: kind.replace('fatal ', ''),
      text: text.replace(/ \[-W.*\]$/, ''),
    }));
