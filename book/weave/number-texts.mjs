// The recorded numbers as the prose prints them, for the labels of figures:  node number-texts.mjs numbers.csv numbers.txt
// A line for each: name, value, text.
import { writeFileSync } from 'node:fs';
import { numberText, readNumbers, unitText } from './numbers.mjs';

const [from, to] = process.argv.slice(2);
const lines = [...readNumbers(from).values()].map(
  ({ name, value, written, unit, digits }) =>
    `${name}\t${written}\t${numberText(value, digits)}${unit && ` ${unitText(unit)}`}\n`,
);
writeFileSync(to, lines.join(''));
