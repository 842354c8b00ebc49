// A table of the book made from the CSV file that the chapter's program wrote.
import { existsSync } from 'node:fs';
import { basename } from 'node:path';
import { readCsv, readRecords } from './csv.mjs';
import { aboutTimes, isTime, timeHtml } from './measured-times.mjs';
import { numberHtml, unitHtml } from './numbers.mjs';
import { escapeHtml } from './text.mjs';

// Map of table name to its columns { column, unit, digits }, as tables.csv lists them.
export function readTables(folder) {
  const path = `${folder}/tables.csv`;
  const tables = new Map();
  if (!existsSync(path)) return tables;
  for (const row of readRecords(path)) {
    if (!tables.has(row.table))
      tables.set(row.table, { name: row.table, path: `${folder}/${row.table}.csv`, columns: [] });
    tables.get(row.table).columns.push(row);
  }
  return tables;
}

// What is wrong with the table's file, or nothing.
export function tableFault(table) {
  if (!existsSync(table.path))
    return `tables.csv describes the table "${table.name}", but ${basename(table.path)} is not there`;
  const header = readCsv(table.path)[0] ?? [];
  const undescribed = header.find(name => !table.columns.some(c => c.column === name));
  return undescribed && `column "${undescribed}" of ${basename(table.path)} has no row in tables.csv`;
}

// { column: its values } for a picture, which shows no more than five digits.
export function tableColumns(table) {
  const [header, ...rows] = readCsv(table.path);
  const cell = text => (Number.isNaN(Number(text)) ? text : Number(Number(text).toPrecision(5)));
  return Object.fromEntries(header.map((name, i) => [name, rows.map(row => cell(row[i]))]));
}

// On a phone a row of so many columns becomes a block of lines, each with the head of its column.
const MANY = 5;

// `hrefOf` gives the page of a header that a cell names.
export function tableHtml(table, times, hrefOf = () => null) {
  const [header, ...rows] = readCsv(table.path);
  const columns = header.map(name => table.columns.find(c => c.column === name));
  const right = (c, i) => c.digits !== 'text' || rows.some(row => isTime(row[i]));
  const align = columns.map((c, i) => (right(c, i) ? ' class="right"' : ''));
  const heads = columns.map((c, i) => `<th scope="col"${align[i]}>${head(c)}</th>`);
  const isBlocks = columns.length >= MANY && columns.filter(c => c.digits === 'text').length > 1;
  const said = c => (isBlocks ? ` data-head="${escapeHtml(c.column + (c.unit ? ` [${c.unit}]` : ''))}"` : '');
  const cell = (field, c) => {
    const href = hrefOf(field);
    const html = cellHtml(field, c, times);
    return href ? `<a href="${href}"><code>${html.replace(/_/g, '_<wbr>')}</code></a>` : html;
  };
  const body = rows.map(
    row =>
      `<tr>${row.map((field, i) => `<td${align[i]}${said(columns[i])}>${cell(field, columns[i])}</td>`).join('')}</tr>`,
  );
  return `<table${isBlocks ? ' class="blocks"' : ''}><thead><tr>${heads.join('')}</tr></thead><tbody>\n${body.join('\n')}\n</tbody></table>${aboutTimes(times, rows.flat())}`;
}

const head = c => escapeHtml(c.column) + (c.unit ? ` <span class="unit">[${unitHtml(c.unit)}]</span>` : '');

// A field as the page prints it; one of words may stand in a column of numbers.
export function cellHtml(field, column, times) {
  if (isTime(field)) return timeHtml(times, field);
  if (column.digits === 'text') return escapeHtml(field);
  if (field === '' || /^[-+]?nan$/i.test(field)) return '–';
  const value = Number(field.replace(/^([-+]?)inf(inity)?$/i, '$1Infinity'));
  return Number.isNaN(value) ? escapeHtml(field) : numberHtml(value, Number(column.digits));
}
