'use strict';
// The doctor takes up to two seconds, so it has a thread and a program of its own: told { program, files } first and
// { id, text } after it, it says { id, findings } or { id, failure }.

let doctor;
onmessage = async ({ data: { program, files, id, text } }) => {
  if (program) return void (doctor = start({ program, files }));
  try {
    postMessage({ id, ...(await doctor)({ ask: 'doctor', text }) });
  } catch (error) {
    postMessage({ id, failure: String(error?.message ?? error) });
  }
};
