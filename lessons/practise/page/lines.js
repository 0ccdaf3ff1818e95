'use strict';
// From a place in a program of WebAssembly to a line of its source: DWARF's table of lines, version 4.

// `program`: the bytes of the module. `file`: the name of the source. Returns a function of an error's stack that gives the
// lines of the calls that lie in that source, the innermost first.
function lineFinder(program, file) {
  const { code, lines } = sectionsOf(program);
  const sequences = lines ? sequencesOf(lines, file) : [];
  const lineAt = address => {
    const rows = sequences.find(rows => rows[0].address <= address && address < rows.at(-1).address);
    // Code of a header that was put in line belongs to the line before it.
    return rows?.findLast(row => row.own && row.address <= address)?.line ?? 0;
  };
  return stack => [...stack.matchAll(/wasm-function\[\d+\]:0x([0-9a-f]+)/g)]
    .map(([, place]) => lineAt(parseInt(place, 16) - code)).filter(line => line > 0);
}

// Reads numbers one after the other.
class Cursor {
  constructor(bytes, at = 0) { this.bytes = bytes; this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length); this.at = at; }
  u8() { return this.bytes[this.at++]; }
  i8() { return this.view.getInt8(this.at++); }
  u16() { return this.view.getUint16((this.at += 2) - 2, true); }
  u32() { return this.view.getUint32((this.at += 4) - 4, true); }
  unsigned() {
    for (let value = 0, shift = 0, byte; ; shift += 7) {
      value += ((byte = this.u8()) & 127) * 2 ** shift;
      if (byte < 128) return value;
    }
  }
  signed() {
    for (let value = 0, shift = 0, byte; ; ) {
      value |= ((byte = this.u8()) & 127) << shift;
      shift += 7;
      if (byte < 128) return byte & 64 && shift < 32 ? value | -1 << shift : value;
    }
  }
  text() {
    const begin = this.at;
    this.at = this.bytes.indexOf(0, begin) + 1;
    return new TextDecoder().decode(this.bytes.subarray(begin, this.at - 1));
  }
}

// Where the code begins, from which DWARF counts, and the table's bytes.
function sectionsOf(program) {
  const from = new Cursor(program, 8), found = { code: 0, lines: undefined };
  while (from.at < program.length) {
    const kind = from.u8(), size = from.unsigned(), begin = from.at;
    if (kind === 10) found.code = begin;
    if (kind === 0) {
      const length = from.unsigned(), name = new TextDecoder().decode(program.subarray(from.at, from.at + length));
      if (name === '.debug_line') found.lines = program.subarray(from.at + length, begin + size);
    }
    from.at = begin + size;
  }
  return found;
}

// The rows { address, line, own } of each run of code, whose last is its end.
function sequencesOf(table, file) {
  const from = new Cursor(table), sequences = [];
  while (from.at < table.length) {
    const end = from.u32() + from.at;
    if (from.u16() !== 4) { from.at = end; continue; }
    const begin = from.u32() + from.at;
    from.at += 3;  // one byte an instruction, one operation, and whether a row is a statement
    const lineBase = from.i8(), lineRange = from.u8(), firstSpecial = from.u8();
    const lengths = Array.from({ length: firstSpecial - 1 }, () => from.u8());
    while (from.text());  // folders
    const own = [false];
    for (let name; (name = from.text()); ) {
      own.push(name === file || name.endsWith('/' + file));
      for (let i = 0; i < 3; ++i) from.unsigned();
    }
    from.at = begin;
    let rows = [], state;
    const restart = () => { state = { address: 0, file: 1, line: 1 }; };
    const row = () => rows.push({ address: state.address, line: state.line, own: own[state.file] && state.line > 0 });
    restart();
    while (from.at < end) {
      const code = from.u8();
      if (code >= firstSpecial) {
        state.address += Math.floor((code - firstSpecial) / lineRange);
        state.line += lineBase + (code - firstSpecial) % lineRange;
        row();
      } else if (code === 0) {
        const length = from.unsigned(), after = from.at + length, what = from.u8();
        if (what === 2) state.address = from.u32();
        if (what === 1) {
          row();
          sequences.push(rows);
          rows = [];
          restart();
        }
        from.at = after;
      } else if (code === 1) row();
      else if (code === 2) state.address += from.unsigned();
      else if (code === 3) state.line += from.signed();
      else if (code === 4) state.file = from.unsigned();
      else if (code === 8) state.address += Math.floor((255 - firstSpecial) / lineRange);
      else if (code === 9) state.address += from.u16();
      else for (let i = 0; i < lengths[code - 1]; ++i) from.unsigned();
    }
    from.at = end;
  }
  return sequences;
}
