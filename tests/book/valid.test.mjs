// The pages are valid HTML, as html-validate has it:  node valid.test.mjs BUILD [others]
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { HtmlValidate, StaticConfigLoader } from 'html-validate';
import config from './.htmlvalidate.mjs';
import { read } from './book.mjs';
import { asked } from './chosen.mjs';

const validator = new HtmlValidate(new StaticConfigLoader(config));

for (const page of asked) {
  test(page, async () => {
    const { results } = await validator.validateString(read(page), page);
    const faults = results.flatMap(({ messages }) => messages);
    assert.ok(
      !faults.length,
      faults.map(({ line, column, message, ruleId }) => `${page}:${line}:${column}: ${message} (${ruleId})`).join('\n'),
    );
  });
}
