// Live figures: their descriptions, and the part of a page that their scripts bring to life.
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { linker } from './api.mjs';
import { edited } from '../../exercises/apply_edit.mjs';
import { readMistake, withMistakes } from '../live/descriptions.mjs';
import { signed } from './blocks.mjs';
import { editableOf } from './editable.mjs';
import { highlightLines } from './highlight.mjs';
import { mergeLines } from './merge-lines.mjs';
import { otherColours } from './method-looks.mjs';
import { sourceHref } from './source-pages.mjs';
import { cutTag } from './snippets.mjs';
import { escapeHtml, smarten } from './text.mjs';

// Where the parts of a chapter's live figures lie: NAME.cpp, NAME.js and NAME.json.
export const liveFolder = chapter => `${chapter.folder}/live`;

// The scripts of every live figure, in the order in which they are loaded.
export const LIVE_SCRIPTS = [
  'module',
  'words',
  'settings',
  'run',
  'ahead',
  'pen',
  'map',
  'names',
  'chart',
  'scrubber',
  'plot',
  'edits',
  'clock',
  'handle',
  'stopwatch',
  'mistakes',
  'links',
  'sight',
  'shown',
  'figure',
  'one-step',
  'plane',
];

// What a page with live figures loads, and no other.
export function liveHead(body) {
  const names = [...body.matchAll(/<figure class="plot" id="[^"]*" data-live="([^"]*)"/g)].map(found => found[1]);
  if (!names.length) return '';
  const scripts = ['compiled', 'live', ...names].map(name => `<script defer src="live/${name}.js"></script>\n`);
  return `<link rel="stylesheet" href="live/live.css">\n${scripts.join('')}`;
}

// name -> { name, folder, file, controls, ... } of each NAME.json; a fault where one cannot be read.
export function readLive({ source, chapters }, problems) {
  return new Map(
    chapters
      .map(liveFolder)
      .flatMap(folder => {
        const files = existsSync(join(source, folder))
          ? readdirSync(join(source, folder))
              .filter(file => file.endsWith('.json'))
              .sort()
          : [];
        return files.map(name => {
          const file = `${folder}/${name}`;
          return {
            name: name.slice(0, -5),
            folder,
            file,
            ...withMistakes(readJson(join(source, file), file, problems)),
          };
        });
      })
      .map(live => [live.name, live]),
  );
}

function readJson(path, file, problems) {
  try {
    return JSON.parse(readFileSync(path, 'utf8'));
  } catch (fault) {
    problems.add(file, 1, `this is no JSON: ${fault.message}`);
    return {};
  }
}

// The code of each method that a figure has, or has to choose from: what moves x and v, cut from its header, or from where `code` says.
export const methodsOf = live =>
  Object.entries(live.methods ?? live.controls.find(({ name }) => name === 'method')?.choices ?? {}).map(
    ([name, label]) => ({
      name,
      label,
      path: `code/integrate/${name}.h`,
      tag: 'move',
      ...live.code?.[name],
    }),
  );

// What stands ready for the scripts; a page whose scripts do not run never shows it.
export function liveHtml({ book }, live) {
  const { scene, shape, chart, timed } = live;
  return `<template><div class="stage${timed ? ' timed' : ''}" role="group" style="--scene:${shape[0] / shape[1]}">
<div class="picture"><p class="axis">${escapeHtml(smarten(scene))}</p><canvas class="scene" role="img" style="aspect-ratio:${shape.join('/')}"></canvas></div>
<div class="keys"><button type="button" data-do="play">Play</button><button type="button" data-do="step">Step</button><button type="button" data-do="reset">Reset</button>${timed ? '<button type="button" data-do="time">Time it here</button>' : ''}
<p class="readout"></p><small>${chart ? paceText(live) : ''}</small></div>
<div class="controls">${live.controls
    .filter(({ chips }) => !chips)
    .map(control => controlHtml(live, control))
    .join('')}
<button type="button" data-do="link">Link to these settings</button>${timed ? '<div class="advice"></div>' : ''}</div>
${chart ? `<div class="graph"><p class="axis">${escapeHtml(smarten(chart.name))}</p><div class="chart" role="img"></div></div>` : ''}
<div class="beside">${timed ? '<div class="ranked"></div>' : ''}${methodsOf(live)
    .flatMap(method => [codeHtml(book, method, null, editing(book, live, method)), ...wrongCode(book, live, method)])
    .join('\n')}${chipsHtml(live)}</div>
<p class="unseen" role="status"></p></div></template>`;
}

// Where time is counted in something else than seconds, how many of it there are in one.
function paceText({ pace, chart }) {
  if (chart?.time) return `${pace} ${chart.time}${pace === 1 ? '' : 's'} a second`;
  if (pace === 1) return 'real time';
  return pace > 1 ? `${pace}× real time` : `${Number((1 / pace).toPrecision(2))}× slow motion`;
}

function controlHtml(live, { name, label, choices, start, values, from, to, by, mark, half }) {
  const words = escapeHtml(smarten(label));
  if (choices) {
    const radios = Object.entries(choices).map(
      ([value, text]) =>
        `<label><input type="radio" name="${live.name}-${name}" value="${value}"${value === start ? ' checked' : ''}> ${escapeHtml(smarten(text))}</label>`,
    );
    return `<fieldset data-control="${name}"><legend>${words}</legend>${radios.join('')}</fieldset>`;
  }
  const range = values ? [0, values.length - 1, 1, values.indexOf(start)] : [from, to, by, start];
  const [min, max, step, value] = range;
  return (
    `<label class="slider${half ? ' half' : ''}" data-control="${name}"><span>${words}</span><span class="value"></span><span class="track"><input type="range" min="${min}" max="${max}" step="${step}" value="${value}">` +
    `${mark ? '<span class="mark" hidden></span>' : ''}</span></label>`
  );
}

function codeHtml(book, { name, label, path, tag }, changed, own = '') {
  const { lines } = book.snippet(path, tag);
  const shown = changed ?? lines;
  const html = highlightLines(shown.map(({ text }) => text).join('\n'), 'cpp', linker(book.api, path))
    .map((line, i) => `<span class="line">${signed(line, shown[i].sign)}</span>`)
    .join('\n');
  return `<div class="listing" data-method="${name}"${own} hidden><p><b>${escapeHtml(smarten(label))}</b> <a class="file" href="${sourceHref(path)}#L${lines[0].number}">${escapeHtml(path)}</a></p><pre><code>${html}</code></pre></div>`;
}

// Where something can stand in the place of a method, a reader may write it, too.
function editing(book, live, { path, tag }) {
  if (!book.config.compiler || !mistakesOf(live).length || tag !== 'move') return '';
  const about = editableOf(readFileSync(join(book.config.source, path), 'utf8'));
  return about === null ? '' : ` data-edit="${escapeHtml(JSON.stringify(about))}"`;
}

const mistakesOf = ({ controls }) => Object.entries(controls.find(({ chips }) => chips)?.choices ?? {});

// The code of a method with each mistake that a figure lets its reader make.
const wrongCode = (book, live, method) =>
  mistakesOf(live)
    .filter(([name]) => name.startsWith(`${method.name}/`))
    .map(([name]) => {
      const { lines } = book.snippet(method.path, method.tag);
      const file = join(book.config.source, method.path);
      const changed = cutTag(edited(file, readMistake(name).file), method.tag);
      return codeHtml(
        book,
        method,
        mergeLines(
          lines.map(({ text }) => text),
          changed,
        ),
        ` data-own="${name}"`,
      );
    });

// One press makes a mistake, and one takes it back. Those of the method that comes first are there at once, so that nothing moves when the
// figure runs; which one a timed figure answers with is not known before.
function chipsHtml(live) {
  const [none, ...mistakes] = mistakesOf(live);
  if (!none) return '';
  const first = live.controls.find(({ name }) => name === 'method')?.start ?? methodsOf(live)[0].name;
  const radio = ([value, text], of = '') =>
    `<label${of && ` data-of="${of}"${of === first ? '' : ' hidden'}`}><input type="radio" name="${live.name}-own" value="${value}"${of ? '' : ' checked'}> ${escapeHtml(smarten(text))}</label>`;
  const { name, label } = live.controls.find(({ chips }) => chips);
  return (
    `<fieldset class="chips" data-control="${name}"${live.timed ? ' hidden' : ''}><legend>${label}</legend>${radio(none)}` +
    `${mistakes.map(mistake => radio(mistake, mistake[0].split('/')[0])).join('')}</fieldset><p class="examined" role="status"></p>`
  );
}

// The colours of the methods, and those of figure.gp, under the names that the figures use: EULER's becomes --euler.
export function colourRules(looks, script) {
  const rules = [...looks.map(({ id, colour }) => [id, colour]), ...otherColours(script)].map(
    ([name, colour]) => `--${name.toLowerCase().replace(/_/g, '-')}:var(--plot-${colour})`,
  );
  return `:root{${rules.join(';')}}\n`;
}
