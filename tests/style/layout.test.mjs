// C++ as .clang-format says, JavaScript as .prettierrc.json does.   node layout.test.mjs SOURCE CLANG_FORMAT
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { sourceFiles } from '../source_files.mjs';

const [source, clangFormat] = process.argv.slice(2);

// Without what is broken or hostile on purpose, and what is only woven.
const files = sourceFiles(source).filter(
  file => !/^tests\/(grader\/corpus\/(broken|hostile)|weave\/sample)\//.test(file),
);

test('C++', () => {
  const sources = files.filter(file => /\.(cpp|h)$/.test(file));
  assert.ok(sources.length > 400, `only ${sources.length} files`);
  const { status, stderr } = spawnSync(clangFormat, ['--dry-run', '-Werror', ...sources], {
    cwd: source,
    encoding: 'utf8',
  });
  assert.equal(status, 0, `run clang-format-19 -i on the files that these lines name:\n${stderr.slice(0, 4000)}`);
});

test('JavaScript', () => {
  const sources = files.filter(file => /\.m?js$/.test(file));
  assert.ok(sources.length > 100, `only ${sources.length} files`);
  const prettier = fileURLToPath(new URL('../../node_modules/prettier/bin/prettier.cjs', import.meta.url));
  const { status, stderr, stdout } = spawnSync(process.execPath, [prettier, '--list-different', ...sources], {
    cwd: source,
    encoding: 'utf8',
  });
  assert.equal(status, 0, `run npx prettier --write on these files:\n${stdout}${stderr}`);
});
