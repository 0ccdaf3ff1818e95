// Rapier 2D. Its multibody joints stay out: they keep a damping that JavaScript cannot turn off.
export async function load(modules) {
  const folder = `${modules}/node_modules/@dimforge/rapier2d-deterministic-compat/dist`;
  const { default: rapier } = await import(`${folder}/rapier.mjs`);
  await rapier.init();
  const point = ([x, y]) => ({ x, y });
  const angle = ([w, , , z]) => 2 * Math.atan2(z, w);

  return ({ scene: { gravity, bodies, pins }, knob }) => {
    const world = new rapier.World(point(gravity));
    world.numSolverIterations = knob('iterations', 4);
    world.integrationParameters.contact_natural_frequency = knob('contact hertz', 30);
    const shapeOf = ({ box, ground }) => {
      if (box) return rapier.ColliderDesc.cuboid(box[0] / 2, box[1] / 2);
      return ground && new rapier.ColliderDesc(new rapier.HalfSpace(point(ground)));
    };
    const all = bodies.map(body => {
      const { fixed, mass, inertia, position: [x, y], rotation, velocity, spin, friction, restitution } = body;
      const made = rapier.RigidBodyDesc[fixed ? 'fixed' : 'dynamic']().setCanSleep(false);
      made.setTranslation(x, y).setRotation(angle(rotation)).setLinvel(velocity[0], velocity[1]).setAngvel(spin[2]);
      if (!fixed) made.setAdditionalMassProperties(mass, { x: 0, y: 0 }, inertia[2]);
      const created = world.createRigidBody(made), shape = shapeOf(body);
      if (shape) world.createCollider(shape.setDensity(0).setFriction(friction).setRestitution(restitution), created);
      return created;
    });
    for (const { bodies: [above, below], arms } of pins)
      world.createImpulseJoint(rapier.JointData.revolute(...arms.map(point)), all[above], all[below], true);
    return {
      step: h => ((world.timestep = h), world.step()),
      bodies: () =>
        all.map(body => {
          const { x, y } = body.translation(), v = body.linvel(), turn = body.rotation() / 2;
          return [x, y, 0, Math.cos(turn), 0, 0, Math.sin(turn), v.x, v.y, 0, 0, 0, body.angvel()];
        }),
      setVelocities: velocities =>
        velocities.forEach(([x, y, , , , spin], i) => {
          if (!bodies[i].fixed) all[i].setLinvel({ x, y }, true), all[i].setAngvel(spin, true);
        }),
      free: () => world.free(),
    };
  };
}
