// What stops the book when a claim is without proof.
import { test } from 'node:test';
import { CHAPTER, CLAIMS, refuses, REPORT } from './weaver.mjs';

const CITED =
  '<TestCase name="Euler gains energy on every step" filename="chapters/2-euler/claims.cpp" line="4">\n    <OverallResult success="true" skips="0"/>';
const UNCITED = CITED.replace('Euler gains energy on every step', 'Nobody cites this claim').replace(
  'line="4"',
  'line="8"',
);
const mark = '\\claim{Euler gains';
const RUN = '\n    run it alone: built/2-euler/claims ';

const failure = (test, line, original, expanded) =>
  test.replace(
    /<Overall.*/s,
    `<Expression success="false" type="REQUIRE" filename="chapters/2-euler/claims.cpp" line="${line}">
      <Original>${original}</Original><Expanded>${expanded}</Expanded></Expression>
    <OverallResult success="false" skips="0"/>`,
  );

test('a claim that no test bears', () =>
  refuses(
    [[CHAPTER, 'Euler gains energy on every\nstep', 'Euler gains energy on each\nstep']],
    [
      CHAPTER,
      '\\claim{',
      'no test bears the name of the claim "Euler gains energy on each step". Did you mean "Euler gains energy on every step"?',
    ],
  ));

test('a claim unlike every test', () =>
  refuses(
    [[CHAPTER, 'Euler gains energy on every\nstep', 'The moon is a cheese']],
    [
      CHAPTER,
      '\\claim{',
      'no test bears the name of the claim "The moon is a cheese". Write the test, or give the sentence another proof.',
    ],
  ));

test('a claim whose test fails', () =>
  refuses(
    [[REPORT, CITED, failure(CITED, 5, 'after &gt; before', '1.0 &gt; 2.0')]],
    [
      CHAPTER,
      mark,
      'the claim is false: "Euler gains energy on every step"\n    chapters/2-euler/claims.cpp:5: after > before, where 1.0 > 2.0' +
        `${RUN}"Euler gains energy on every step"`,
    ],
  ));

test('a failing test that no claim cites', () =>
  refuses(
    [[REPORT, UNCITED, failure(UNCITED, 9, '1 &lt; 2', '1 &lt; 2')]],
    [
      CLAIMS,
      'Nobody cites',
      `this test fails: "Nobody cites this claim"\n    chapters/2-euler/claims.cpp:9: 1 < 2, where 1 < 2${RUN}"Nobody cites this claim"`,
    ],
  ));

test('a check that threw', () =>
  refuses(
    [
      [
        REPORT,
        CITED,
        failure(CITED, 5, 'at(7) == 0', 'at(7) == 0').replace(
          '</Expression>',
          '<Exception filename="chapters/2-euler/claims.cpp" line="5">out of range</Exception></Expression>',
        ),
      ],
    ],
    [
      CHAPTER,
      mark,
      `the claim is false: "Euler gains energy on every step"\n    chapters/2-euler/claims.cpp:5: at(7) == 0 threw: out of range${RUN}"Euler gains energy on every step"`,
    ],
  ));

test('a test that threw, failed by hand, or was skipped', () => {
  const at = 'filename="chapters/2-euler/claims.cpp"';
  refuses(
    [
      [
        REPORT,
        CITED,
        CITED.replace(
          /<Overall.*/,
          `<Section name="inner" ${at} line="5"><Exception ${at} line="6">out of range</Exception>
      <Failure ${at} line="7">by hand</Failure></Section><OverallResult success="false" skips="0"/>`,
        ),
      ],
      [
        REPORT,
        UNCITED,
        UNCITED.replace(/<Overall.*/, `<Skip ${at} line="9">no time</Skip><OverallResult success="true" skips="1"/>`),
      ],
    ],
    [
      CHAPTER,
      mark,
      'the claim is false: "Euler gains energy on every step"\n    chapters/2-euler/claims.cpp:6: exception: out of range\n' +
        `    chapters/2-euler/claims.cpp:7: failure: by hand${RUN}"Euler gains energy on every step"`,
    ],
    [
      CLAIMS,
      'Nobody cites',
      `this test fails: "Nobody cites this claim"\n    chapters/2-euler/claims.cpp:9: skip: no time${RUN}"Nobody cites this claim"`,
    ],
  );
});

test('a name as a shell and Catch2 want it', () =>
  refuses(
    [
      [
        REPORT,
        UNCITED,
        failure(UNCITED, 9, 'x', 'false').replace('Nobody cites this claim', 'a, b [c] $d &quot;e&quot;'),
      ],
    ],
    [
      CLAIMS,
      'TEST_CASE("Nobody',
      `this test fails: "a, b [c] $d "e""\n    chapters/2-euler/claims.cpp:9: x, where false${RUN}"a\\\\, b \\\\[c\\\\] \\$d \\"e\\""`,
    ],
  ));

test('a file named from the folder of the build, as by a compiler behind a cache', () =>
  refuses(
    [[REPORT, CITED, failure(CITED, 5, 'after &gt; before', '1.0 &gt; 2.0').replaceAll('"chapters/', '"../chapters/')]],
    [
      CHAPTER,
      mark,
      'the claim is false: "Euler gains energy on every step"\n    chapters/2-euler/claims.cpp:5: after > before, where 1.0 > 2.0' +
        `${RUN}"Euler gains energy on every step"`,
    ],
  ));

test('a report that ends in the middle', () =>
  refuses(
    [
      [REPORT, '</Catch2TestRun>', ''],
      [CHAPTER, '\n\\claim{Euler gains energy on every\nstep}', ''],
    ],
    [CLAIMS, '', 'the report of the claims ends in the middle: the claims program crashed; run built/2-euler/claims'],
  ));

test('no report at all', () =>
  refuses(
    [[REPORT], [CHAPTER, '\n\\claim{Euler gains energy on every\nstep}', '']],
    [CLAIMS, '', 'there is no report of the claims at built/2-euler/claims.xml; build the chapter first'],
  ));
