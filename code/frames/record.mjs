// Records frame times of a busy page in the distribution's Chromium, and writes them as a C++ header.
//   node code/frames/record.mjs > mine.h
// It needs what ./setup.sh brings. On a fast machine give the page more to do: --sparks 4000
import { existsSync } from 'node:fs';
import { cpus } from 'node:os';
import { parseArgs } from 'node:util';
import { chromium } from 'playwright-core';

const warmUp = 60,
  frames = 600;
const { values: load } = parseArgs({
  options: {
    sparks: { type: 'string', default: '1000' }, // discs drawn in a frame, on average
    swing: { type: 'string', default: '800' }, // how far their number swells and ebbs
    room: { type: 'string', default: '150000' }, // things made and sorted for each new room
  },
});

async function record() {
  const executablePath =
    process.env.CHROMIUM ??
    [
      '/usr/bin/chromium',
      '/usr/bin/chromium-browser',
      '/usr/bin/google-chrome',
      '/usr/bin/chromium-headless-shell',
    ].find(existsSync);
  const args = ['--disable-gpu', '--no-first-run', '--disable-background-networking'];
  const browser = await chromium.launch({ executablePath, chromiumSandbox: false, args });
  try {
    const page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
    await page.goto(`${new URL('record.html', import.meta.url)}?${new URLSearchParams(load)}`);
    const clock = await page.evaluate(count => window.record(count), warmUp + frames);
    return { version: browser.version(), times: clock.slice(warmUp) };
  } finally {
    await browser.close();
  }
}

// A recording is of use where it is uneven: the header promises this, and tests/frames checks it.
function check(lengths) {
  const share = fits => lengths.filter(fits).length / lengths.length;
  const mean = lengths.reduce((sum, length) => sum + length) / lengths.length;
  const jitters =
    mean > 0.017 && mean < 0.025 && share(s => Math.abs(s - 1 / 60) < 0.002) > 0.5 && share(s => s > 1 / 30) > 0.02;
  if (jitters) return;
  console.error(
    `Too even or too slow, with a mean of ${(1000 * mean).toFixed(1)} ms: try again with more or fewer --sparks`,
  );
  process.exit(1);
}

function header(lengths, version) {
  const rows = [];
  for (let i = 0; i < lengths.length; i += 12)
    rows.push(
      lengths
        .slice(i, i + 12)
        .map(s => s.toFixed(4))
        .join(', '),
    );
  return `// SPDX-License-Identifier: MIT-0
/// @file
/// Frames that a machine really took, one after the other.
#pragma once
#include <array>
#include <cstddef>

namespace frames {

/// How long each of ${lengths.length} frames took, as the page itself read its clock [s].
///
/// Recorded on ${new Date().toISOString().slice(0, 10)} by record.mjs: headless Chromium ${version.split('.')[0]} drawing record.html in
/// software, ${load.sparks} discs a frame with a swing of ${load.swing} and now and then a new room of ${load.room}
/// things, on ${cpus().length} cores that other programs shared. It asked for 60 frames a second, and its clock
/// ticks in tenths of a millisecond. More than half of the frames come within two milliseconds of a
/// sixtieth of a second, at least one in fifty takes longer than a thirtieth, and the mean lies
/// between 17 and 25 ms.
///
/// For frames of your own machine: \`node code/frames/record.mjs > code/frames/recorded.h\`.
// clang-format off
inline constexpr std::array<double, ${lengths.length}> recorded{
  ${rows.join(',\n  ')}};
// clang-format on

/// The recorded frames from some place on; after the last comes the first again.
struct Playback {
  std::size_t at = 0;  ///< which frame comes next

  /// Length of the next frame [s].
  constexpr double next() { return recorded[at++ % recorded.size()]; }
};

}  // namespace frames
`;
}

const { version, times } = await record();
const lengths = times.slice(1).map((time, i) => Math.round((time - times[i]) * 10) / 10000);
check(lengths);
process.stdout.write(header(lengths, version));
