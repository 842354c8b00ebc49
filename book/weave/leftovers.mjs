// Markup that Markdown did not take for markup.
const LEFT = /\*\*|\*(?=\w)|(?<=\w)\*|\]\(|\]\[|\[\^|\||--+/g;

export function findLeftovers(tokens, report) {
  for (const { line, text } of linesOf(tokens))
    for (const { 0: found, index } of text.matchAll(LEFT))
      report(
        line,
        `"${found}" was left standing in "${text.slice(Math.max(0, index - 12), index + 13).trim()}": Markdown did not take it for markup; write \\${found[0]} if it is meant so`,
      );
}

// What is meant as it stands, such as a mark or \*, is a gap.
function linesOf(tokens) {
  const lines = [];
  for (const { type, content, map } of tokens) {
    const line = map?.[1] ?? lines.at(-1)?.line;
    if (lines.at(-1)?.line !== line) lines.push({ line, text: '' });
    lines.at(-1).text += type === 'text' ? content : ' ';
  }
  return lines;
}
