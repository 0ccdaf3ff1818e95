'use strict';
// What a program of WebAssembly asks of its system (WASI, snapshot preview 1): the time, files to be read, and
// somewhere to write its complaints.

const success = 0, badDescriptor = 8, noEntry = 44;

// `files`: contents by path, "fonts/DejaVuSans.ttf".
function wasi(files, complain) {
  let memory;
  const open = new Map();  // by descriptor; 3 is the folder of all files
  let next = 4;
  const view = () => new DataView(memory.buffer);
  const bytes = (at, length) => new Uint8Array(memory.buffer, at, length);
  const text = (at, length) => new TextDecoder().decode(bytes(at, length));
  const vectors = (at, count) => Array.from({ length: count }, (_, i) =>
    bytes(view().getUint32(at + 8 * i, true), view().getUint32(at + 8 * i + 4, true)));

  const calls = {
    clock_time_get(_clock, _precision, at) {
      view().setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true);
      return success;
    },
    environ_sizes_get(count, size) {
      view().setUint32(count, 0, true);
      view().setUint32(size, 0, true);
      return success;
    },
    environ_get: () => success,
    args_sizes_get(count, size) { return calls.environ_sizes_get(count, size); },
    args_get: () => success,
    fd_prestat_get(descriptor, at) {
      if (descriptor !== 3) return badDescriptor;
      view().setUint32(at, 0, true);
      view().setUint32(at + 4, 1, true);
      return success;
    },
    fd_prestat_dir_name(_descriptor, at) {
      bytes(at, 1)[0] = '/'.charCodeAt(0);
      return success;
    },
    fd_fdstat_get(descriptor, at) {
      const folder = descriptor === 3, file = open.has(descriptor);
      bytes(at, 24).fill(0);
      view().setUint8(at, folder ? 3 : file ? 4 : 2);
      view().setBigUint64(at + 8, ~0n & 0xffffffffffffffffn, true);   // all rights
      view().setBigUint64(at + 16, ~0n & 0xffffffffffffffffn, true);
      return success;
    },
    fd_fdstat_set_flags: () => success,
    path_open(_folder, _look, path, length, _how, _rights, _inherited, _flags, at) {
      const content = files.get(text(path, length));
      if (!content) return noEntry;
      open.set(next, { content, place: 0 });
      view().setUint32(at, next++, true);
      return success;
    },
    fd_read(descriptor, at, count, read) {
      const file = open.get(descriptor);
      if (!file) return badDescriptor;
      let total = 0;
      for (const room of vectors(at, count)) {
        const part = file.content.subarray(file.place, file.place + room.length);
        room.set(part);
        file.place += part.length;
        total += part.length;
      }
      view().setUint32(read, total, true);
      return success;
    },
    fd_seek(descriptor, offset, from, at) {
      const file = open.get(descriptor);
      if (!file) return badDescriptor;
      file.place = Number(offset) + [0, file.place, file.content.length][from];
      view().setBigUint64(at, BigInt(file.place), true);
      return success;
    },
    fd_close(descriptor) { return open.delete(descriptor) ? success : badDescriptor; },
    fd_write(_descriptor, at, count, written) {
      const parts = vectors(at, count);
      complain(parts.map(part => new TextDecoder().decode(part)).join(''));
      view().setUint32(written, parts.reduce((sum, part) => sum + part.length, 0), true);
      return success;
    },
    proc_exit(status) { throw new Error(`the lesson ended with status ${status}`); },
  };
  return { calls, use(its) { memory = its; } };
}

// The files of an archive as `tar --format=ustar` writes it, by path.
function untar(archive) {
  const files = new Map();
  const field = (at, length) => new TextDecoder().decode(archive.subarray(at, at + length)).replace(/\0.*/s, '');
  for (let at = 0; at + 512 <= archive.length && archive[at];) {
    const size = parseInt(field(at + 124, 12), 8), folder = field(at + 345, 155);
    files.set((folder ? folder + '/' : '') + field(at, 100), archive.subarray(at + 512, at + 512 + size));
    at += 512 + 512 * Math.ceil(size / 512);
  }
  return files;
}
