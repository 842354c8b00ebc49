// Joins the judges' module and a student's, as `grade` joins a judge and a driver: exercises/grader/page is the other side.

// exercises/grader/page/ending.h has the same numbers.
const ENDINGS = {
  trapped: -1,
  outside: -2,
  tooDeep: -3,
  threw: -4,
  left: -5,
  leftByError: -6,
  printedTooMuch: -7,
  noMemory: -8,
};
const LOST = -1; // in_a_process.cpp has it, too
const MOST = 1 << 20; // bytes that a program may print

class Ended extends Error {
  constructor(ending) {
    super(ending);
    this.ending = ending;
  }
}

// A call without end: each browser has an error of its own for that.
const isTooDeep = fault => fault instanceof RangeError || fault?.name === 'InternalError';

function endingOf(fault) {
  if (fault instanceof Ended) return fault.ending;
  if (isTooDeep(fault)) return 'tooDeep';
  if (!(fault instanceof WebAssembly.RuntimeError)) throw fault; // ours
  return /out of bounds/.test(fault.message) ? 'outside' : 'trapped';
}

// Of what a program may ask the system for there is nothing, but it may print and exit.
function system(memory, printed = () => {}) {
  const NOT_THERE = 52;
  const own = {
    proc_exit(code) {
      throw new Ended(code === 0 ? 'left' : 'leftByError');
    },
    fd_write(_file, pieces, count, written) {
      const view = new DataView(memory().buffer);
      let bytes = 0;
      for (let i = 0; i < count; ++i) bytes += view.getUint32(pieces + 8 * i + 4, true);
      view.setUint32(written, bytes, true);
      printed(bytes);
      return 0;
    },
  };
  return new Proxy(own, { get: (there, name) => there[name] ?? (() => NOT_THERE) });
}

class Student {
  constructor(module, ask, ways) {
    let printed = 0;
    const memory = () => this.exports.memory;
    const count = bytes => {
      if ((printed += bytes) > MOST) throw new Ended('printedTooMuch');
    };
    const end = ending => () => {
      throw new Ended(ending);
    };
    const judge = { ask: at => ask(memory(), at), threw: end('threw'), no_memory: end('noMemory') };
    const { exports } = new WebAssembly.Instance(module, {
      judge,
      wasi_snapshot_preview1: system(memory, count),
      ways: ways(memory),
    });
    this.exports = exports;
    exports._initialize();
  }
  answer(which, numbers) {
    const at = this.exports.room(numbers.length);
    new Float64Array(this.exports.memory.buffer, at, numbers.length).set(numbers);
    const count = this.exports.answer_one(which);
    this.answered = new Float64Array(this.exports.memory.buffer, this.exports.answered(), count);
    return count;
  }
}

/** The judges at work on one student's module. */
class Judge {
  constructor(judges, module, told, ways) {
    Object.assign(this, { judges, module, told, ways, students: [] });
    this.exports = this.instance();
    this.exports._initialize();
  }
  get memory() {
    return this.exports.memory;
  }
  numbers(at, count) {
    return new Float64Array(this.memory.buffer, at, count);
  }
  text(at, length) {
    return new TextDecoder().decode(new Uint8Array(this.memory.buffer, at, length));
  }

  // A module of the judges', and what it asks the page for.
  instance() {
    const attempt = act => {
      const stack = exports.__stack_pointer.value;
      try {
        exports.call_attempted(act);
        return 1;
      } catch (fault) {
        endingOf(fault);
        exports.__stack_pointer.value = stack;
        return 0;
      }
    };
    const page = {
      attempt,
      copy: () => this.copy(),
      compute_in_copy: (compute, place) => this.computeInCopy(compute, place),
      so_far: (at, length) => this.told(JSON.parse(this.text(at, length))),
      begin: () => this.begin(),
      end: number => delete this.students[number],
      call: (number, which, at, count) => this.call(number, which, this.numbers(at, count)),
      answer: (number, at) => {
        const { answered } = this.students[number];
        this.numbers(at, answered.length).set(answered);
      },
    };
    const { exports } = new WebAssembly.Instance(this.judges, {
      page,
      wasi_snapshot_preview1: system(() => exports.memory),
    });
    return exports;
  }

  // The stack's end comes along: what the copy calls lies below what called for it. One module is copied into again and again: to
  // make one takes longer.
  copy() {
    this.copied ??= this.instance();
    const { memory, __stack_pointer } = this.copied;
    const missing = this.memory.buffer.byteLength - memory.buffer.byteLength;
    if (missing > 0) memory.grow(missing >> 16);
    new Uint8Array(memory.buffer).set(new Uint8Array(this.memory.buffer));
    __stack_pointer.value = this.exports.__stack_pointer.value;
  }
  computeInCopy(compute, place) {
    try {
      return this.copied.call_in_copy(compute, place);
    } catch (fault) {
      endingOf(fault);
      return LOST;
    }
  }

  begin() {
    try {
      this.students.push(new Student(this.module, (memory, at) => this.ask(memory, at), this.ways));
    } catch (fault) {
      this.students.push({
        answer: () => {
          throw fault;
        },
      }); // it ended before its first answer
    }
    return this.students.length - 1;
  }
  call(number, which, numbers) {
    try {
      return this.students[number].answer(which, numbers);
    } catch (fault) {
      return ENDINGS[endingOf(fault)];
    }
  }
  ask(memory, at) {
    const asked = this.exports.question();
    this.numbers(asked, 7).set(new Float64Array(memory.buffer, at, 7));
    this.exports.ask_judge(asked);
    new Float64Array(memory.buffer, at, 3).set(this.numbers(asked, 3));
  }

  judge(exercise, seed) {
    const name = new TextEncoder().encode(exercise);
    const room = this.exports.room(name.length);
    new Uint8Array(this.memory.buffer, room, name.length).set(name);
    const length = this.exports.judge(seed);
    return JSON.parse(this.text(this.exports.report(), length));
  }
}

/**
 * @param judges  the module of all judges
 * @param module  a student's, compiled with exercises/grader/harness/module.cpp
 * @param seed  1 is the public one
 * @param told  called as each test begins, with the report if that never ends
 * @param ways  of the proofs alone, whose modules hold many submissions: called with what returns the module's memory
 * @returns the report that `grade` would make, { exercise, verdict, headline, sentence, why, score, points, tests }
 */
export const judge = (judges, module, exercise, seed, told, ways = () => ({})) =>
  new Judge(judges, module, told, ways).judge(exercise, seed);
