// The distribution's Firefox, by the protocol that it speaks itself.
import playwright from 'playwright-core';

/** Ends the test as skipped, with 77, where this Firefox is too old to be driven. */
export const openFirefox = executablePath =>
  // Playwright has it as an experiment; its own build of Firefox comes from no distribution.
  playwright._bidiFirefox.launch({ executablePath }).catch(fault => {
    const [, command] = fault.message.match(/\((\S+)\): unknown command/) ?? [];
    if (!command) throw fault;
    console.log(`skipped: this Firefox is too old to be driven, since it lacks ${command}`);
    process.exit(77);
  });
