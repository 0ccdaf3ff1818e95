'use strict';
// OpenGL's functions, as far as the painter calls them, over WebGL 2. WebAssembly passes numbers: places in its memory,
// and for objects their numbers in a table.

const R16 = 0x822a;

// `canvas` is made when something is first drawn. `memory()`: of the program.
function openGl(canvas, memory) {
  let made, sixteenBits;  // of a channel; without them half a float does
  const gl = () => {
    if (!made) {
      made = canvas().getContext('webgl2', { antialias: false });
      sixteenBits = made.getExtension('EXT_texture_norm16');
      made.getExtension('EXT_color_buffer_float');
    }
    return made;
  };
  const objects = [null], number = object => objects.push(object) - 1;
  const bytes = (at, length) => new Uint8Array(memory(), at, length), view = () => new DataView(memory());
  const text = at => {
    const from = new Uint8Array(memory(), at);
    return new TextDecoder().decode(from.slice(0, from.indexOf(0)));
  };
  const generate = kind => (count, at) => {
    for (let i = 0; i < count; ++i) view().setUint32(at + 4 * i, number(gl()['create' + kind]()), true);
  };
  const places = new Map();  // of uniforms, by program and name

  const calls = {
    glGetShaderInfoLog: () => {},
    glShaderSource(shader, _count, list) {
      const source = text(view().getUint32(list, true));
      gl().shaderSource(objects[shader], source.replace('#version 330 core', '#version 300 es\nprecision highp float;\nprecision highp int;'));
    },
    glGetShaderiv(shader, what, at) { view().setInt32(at, gl().getShaderParameter(objects[shader], what) ? 1 : 0, true); },
    glGetProgramiv(program, what, at) { view().setInt32(at, gl().getProgramParameter(objects[program], what) ? 1 : 0, true); },
    glCreateProgram: () => number(gl().createProgram()),
    glCreateShader: kind => number(gl().createShader(kind)),
    glAttachShader(program, shader) { gl().attachShader(objects[program], objects[shader]); },
    glCompileShader(shader) { gl().compileShader(objects[shader]); },
    glDeleteShader(shader) { gl().deleteShader(objects[shader]); },
    glLinkProgram(program) { gl().linkProgram(objects[program]); },
    glUseProgram(program) { gl().useProgram(objects[program]); },
    glGetUniformLocation(program, name) {
      const key = `${program} ${text(name)}`;
      if (!places.has(key)) places.set(key, number(gl().getUniformLocation(objects[program], text(name))));
      return places.get(key);
    },
    glUniform1i(place, a) { gl().uniform1i(objects[place], a); },
    glUniform1f(place, a) { gl().uniform1f(objects[place], a); },
    glUniform2f(place, a, b) { gl().uniform2f(objects[place], a, b); },
    glUniform3f(place, a, b, c) { gl().uniform3f(objects[place], a, b, c); },
    glUniform4f(place, a, b, c, d) { gl().uniform4f(objects[place], a, b, c, d); },
    glUniformMatrix4fv(place, count, transpose, at) {
      gl().uniformMatrix4fv(objects[place], !!transpose, new Float32Array(memory(), at, 16 * count));
    },
    glTexImage2D(target, level, inner, width, height, border, format, type, at) {
      if (inner === R16 && !sixteenBits) [inner, type] = [gl().R16F, gl().HALF_FLOAT];
      const channels = format === gl().RGBA ? 4 : format === gl().RGB ? 3 : 1;
      gl().texImage2D(target, level, inner, width, height, border, format, type, at ? bytes(at, width * height * channels) : null);
    },
    glBufferData(target, size, at, use) { gl().bufferData(target, bytes(at, size), use); },
    glVertexAttribPointer(index, size, type, normal, stride, at) { gl().vertexAttribPointer(index, size, type, !!normal, stride, at); },
    glFramebufferTexture2D(target, place, kind, texture, level) { gl().framebufferTexture2D(target, place, kind, objects[texture], level); },
    glFramebufferRenderbuffer(target, place, kind, buffer) { gl().framebufferRenderbuffer(target, place, kind, objects[buffer]); },
    // WebGL reads no pixels without their opacity.
    glReadPixels(x, y, width, height, _format, _type, at) {
      const four = new Uint8Array(4 * width * height), three = bytes(at, 3 * width * height);
      gl().readPixels(x, y, width, height, gl().RGBA, gl().UNSIGNED_BYTE, four);
      for (let from = 0, to = 0; from < four.length; from += 4, to += 3) {
        three[to] = four[from];
        three[to + 1] = four[from + 1];
        three[to + 2] = four[from + 2];
      }
    },
  };
  for (const kind of ['Texture', 'Framebuffer', 'Renderbuffer', 'Buffer', 'VertexArray']) {
    calls[`glGen${kind}s`] = generate(kind);
    calls[`glDelete${kind}s`] = (count, at) => {
      for (let i = 0; i < count; ++i) gl()['delete' + kind](objects[view().getUint32(at + 4 * i, true)]);
    };
    const bind = 'bind' + kind;
    calls['glB' + bind.slice(1)] = kind === 'VertexArray' ? object => gl()[bind](objects[object]) : (target, object) => gl()[bind](target, objects[object]);
  }
  // The others pass numbers on as they are: glDrawArrays is drawArrays.
  return new Proxy(calls, { get: (own, name) => own[name] ?? ((...numbers) => gl()[name[2].toLowerCase() + name.slice(3)](...numbers)) });
}
