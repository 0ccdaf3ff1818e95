// MuJoCo. Its model comes as XML, in which bodies have their numbers as names.
export async function load(modules) {
  const { default: create } = await import(`${modules}/node_modules/@mujoco/mujoco/mujoco.js`);
  const mujoco = await create({ print() {}, printErr() {} });
  const body = mujoco.mjtObj.mjOBJ_BODY.value;
  const velocity = new mujoco.DoubleBuffer(6); // of rotation, of the centre

  return ({ scene: { flat, bodies, pins, model: text } }) => {
    const model = mujoco.MjModel.from_xml_string(text), data = new mujoco.MjData(model);
    // It would begin anew where numbers overflow.
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_AUTORESET.value;
    const places = bodies.map((_, i) => mujoco.mj_name2id(model, body, `${i}`));
    const free = bodies.map(({ fixed }, i) => !fixed && pins.every(({ bodies: [, below] }) => below !== i));
    const rotation = i => data.xquat.slice(4 * places[i], 4 * places[i] + 4);
    const setVelocities = all =>
      all.forEach((v, i) => {
        if (!free[i]) return;
        // A free joint counts spin along the axes of the body.
        const rates = flat ? [v[0], v[1], v[5]] : [...v.slice(0, 3), ...turnedBack(v.slice(3), rotation(i))];
        data.qvel.set(rates, model.jnt_dofadr[model.body_jntadr[places[i]]]);
      });
    mujoco.mj_kinematics(model, data);
    setVelocities(bodies.map(({ velocity: v, spin }) => [...v, ...spin]));
    return {
      step: h => ((model.opt.timestep = h), mujoco.mj_step(model, data)),
      bodies: () => {
        // After a step positions are new, but what follows from them is that of its beginning.
        for (const follow of ['mj_kinematics', 'mj_comPos', 'mj_comVel']) mujoco[follow](model, data);
        return places.map((place, i) => {
          mujoco.mj_objectVelocity(model, data, body, place, velocity, 0);
          const v = velocity.GetView();
          return [...data.xpos.slice(3 * place, 3 * place + 3), ...rotation(i), ...v.slice(3), ...v.slice(0, 3)];
        });
      },
      setVelocities,
      free: () => (data.delete(), model.delete()),
    };
  };
}

/// v as seen from a body of this rotation q: v − 2w(u × v) + 2u × (u × v), for q = (w, u).
function turnedBack(v, [w, ...u]) {
  const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
  const once = cross(u, v), twice = cross(u, once);
  return v.map((part, k) => part - 2 * w * once[k] + 2 * twice[k]);
}
