// What no file of this repository can be: links, pipes, archives, strange names and encodings.
import { execFileSync } from 'node:child_process';
import { chmodSync, linkSync, mkdirSync, symlinkSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';

const header = 'orbit-drift.h';

// Items: what stands in the folder `at`, and which path is graded; `solution` is a right text.
export function generated(solution) {
  const write = (path, content) => {
    mkdirSync(dirname(path), { recursive: true });
    writeFileSync(path, content);
    return path;
  };
  const file = content => at => write(join(at, header), content);
  const named = name => at => write(join(at, name), solution);
  const tree = names => at => {
    for (const [name, content] of Object.entries(names)) write(join(at, name), content);
    return at;
  };
  const beside = make => at => (make(at, write(join(at, 'real.h'), solution), join(at, header)), join(at, header));
  const zip = Buffer.concat([Buffer.from('PK\x03\x04'), Buffer.alloc(26), Buffer.from('../../grade.sh')]);

  return [
    ['hostile/53-line-break-in-name', 'ACCEPTED', named('a\nb\x1b[31m.h')],
    ['hostile/53-option-as-name', 'ACCEPTED', named('-rf')],
    ['hostile/53-command-in-name', 'ACCEPTED', named('$(touch corpus-was-here);`touch corpus-was-here`.h')],
    ['hostile/53-longest-name', 'ACCEPTED', named(`${'n'.repeat(253)}.h`)],
    [
      'hostile/53-name-of-no-encoding',
      'ACCEPTED',
      at => {
        write(join(at, header), solution);
        writeFileSync(Buffer.concat([Buffer.from(`${at}/`), Buffer.from([0xff, 0xfe, 0x0a])]), 'x');
        return at;
      },
    ],
    ['hostile/57-symbolic-link', 'REJECTED', beside((at, real, link) => symlinkSync(real, link)), 'symbolic link'],
    [
      'hostile/57-link-to-passwd',
      'REJECTED',
      beside((at, real, link) => symlinkSync('/etc/passwd', link)),
      'symbolic link',
    ],
    [
      'hostile/57-linked-folder',
      'REJECTED',
      at => {
        write(join(at, 'real', header), solution);
        symlinkSync(join(at, 'real'), join(at, '2-euler'));
        return at;
      },
    ],
    ['hostile/58-archive-that-climbs', 'REJECTED', file(zip), 'is a zip archive'],
    [
      'hostile/59-archive-that-grows',
      'REJECTED',
      file(Buffer.concat([zip, Buffer.alloc(1 << 20)])),
      'is a zip archive',
    ],
    ['hostile/59-gzip', 'REJECTED', file(Buffer.from([0x1f, 0x8b, 8, 0])), 'is a gzip archive'],
    ['hostile/60-pipe', 'REJECTED', beside((at, real, pipe) => execFileSync('mkfifo', [pipe])), 'no regular file'],
    ['hostile/60-device', 'REJECTED', () => '/dev/zero', 'no regular file'],
    ['hostile/60-hard-link', 'ACCEPTED', beside(linkTo)],
    [
      'hostile/60-setuid',
      'REJECTED',
      at => (chmodSync(write(join(at, header), solution), 0o4755), join(at, header)),
      'setuid',
    ],
    ['hostile/60-folder-as-header', 'REJECTED', at => (mkdirSync(join(at, header)), at), 'is a folder'],
    ['hostile/60-program', 'REJECTED', file(Buffer.from('\x7fELF\x02\x01\x01')), 'is a compiled program'],
    [
      'hostile/60-build-files',
      'ACCEPTED',
      tree({
        [header]: solution,
        'a.out': '#!/bin/sh\ntouch /tmp/corpus-was-here\n',
        'CMakeLists.txt': 'execute_process(COMMAND touch /tmp/corpus-was-here)\n',
        'compile_flags.txt': '-include /etc/passwd\n',
        [`${header}.gch`]: 'gpch',
        'given.h': '#error taken\n',
        'ld.so.preload': '/tmp/evil.so\n',
        '.git/hooks/post-checkout': '#!/bin/sh\ntouch /tmp/corpus-was-here\n',
      }),
    ],

    ['broken/02-empty', 'REJECTED', file(''), 'is empty'],
    ['broken/02-only-comments', 'COMPILE_ERROR', file('// to be done\n'), 'step is missing'],
    ['broken/03-missing', 'REJECTED', tree({ 'README.md': 'x' }), '2-euler/orbit-drift.h'],
    ['broken/04-other-case', 'REJECTED', tree({ 'Orbit_Drift.hpp': solution }), 'is it Orbit_Drift.hpp?'],
    [
      'broken/05-extra-files',
      'ACCEPTED',
      tree({ [header]: solution, 'README.md': 'x', '.DS_Store': 'x', 'orbit.csv': '1,2' }),
      '.DS_Store',
    ],
    ['broken/06-huge', 'REJECTED', file(solution + '// more\n'.repeat(40000)), '64 KiB'],
    ['broken/07-byte-order-mark', 'ACCEPTED', file(`\ufeff${solution}`)],
    ['broken/08-utf-16', 'REJECTED', file(Buffer.from(`\ufeff${solution}`, 'utf16le')), 'save it as UTF-8'],
    ['broken/08-latin-1', 'REJECTED', file(Buffer.from(`// Gr\u00f6\u00dfe\n${solution}`, 'latin1')), 'see line 1'],
    [
      'broken/09-line-ends-of-windows',
      'ACCEPTED',
      file(`${solution}inline const char* text = R"(one\ntwo)";\n#define TWO \\\n  2\n`.replaceAll('\n', '\r\n')),
    ],
  ].map(([name, verdict, make, says]) => ({ name, verdict, make, says, source: '' }));
}

const linkTo = (at, real, link) => linkSync(real, link);
