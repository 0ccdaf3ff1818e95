// Jolt, its build for one thread, which has no SIMD.
export async function load(modules) {
  const { default: init } = await import(`${modules}/node_modules/jolt-physics/dist/jolt-physics.wasm-compat.js`);
  const jolt = await init();
  const held = jolt.EOverrideMassProperties_MassAndInertiaProvided;
  const [still, moving, shapeless] = [0, 1, 2]; // layers

  // Arguments are filled anew for each call.
  const filled = maker => ([x, y, z], k = 0) => (maker[k].Set(x, y, z), maker[k]);
  const vector = filled([new jolt.Vec3(), new jolt.Vec3()]), point = filled([new jolt.RVec3(), new jolt.RVec3()]);
  const turned = new jolt.Quat();
  const numbers = v => [v.GetX(), v.GetY(), v.GetZ()];

  return ({ scene: { flat, gravity, bodies, pins }, knob }) => {
    const settings = new jolt.JoltSettings(), pairs = new jolt.ObjectLayerPairFilterTable(3);
    pairs.EnableCollision(still, moving), pairs.EnableCollision(moving, moving);
    const broad = new jolt.BroadPhaseLayerInterfaceTable(3, 2);
    for (const layer of [still, moving, shapeless])
      broad.MapObjectToBroadPhaseLayer(layer, new jolt.BroadPhaseLayer(layer === still ? 0 : 1));
    settings.mObjectLayerPairFilter = pairs;
    settings.mBroadPhaseLayerInterface = broad;
    settings.mObjectVsBroadPhaseLayerFilter = new jolt.ObjectVsBroadPhaseLayerFilterTable(broad, 2, pairs, 3);
    const world = new jolt.JoltInterface(settings), system = world.GetPhysicsSystem(), own = system.GetBodyInterface();
    jolt.destroy(settings);
    const physics = system.GetPhysicsSettings();
    physics.mAllowSleeping = false;
    physics.mNumVelocitySteps = knob('velocity iterations', physics.mNumVelocitySteps);
    physics.mNumPositionSteps = knob('position iterations', physics.mNumPositionSteps);
    physics.mPenetrationSlop = knob('slop', physics.mPenetrationSlop);
    system.SetPhysicsSettings(physics);
    system.SetGravity(vector(gravity));

    const shapeOf = ({ box, ground }) => {
      if (box) return new jolt.BoxShape(vector(box.map(side => side / 2)));
      return ground ? new jolt.PlaneShape(new jolt.Plane(vector(ground), 0)) : new jolt.SphereShape(0.01);
    };
    const all = bodies.map(body => {
      const { fixed, mass, inertia, position, rotation, velocity, spin, box, ground, friction, restitution } = body;
      const [w, x, y, z] = rotation, motion = jolt[`EMotionType_${fixed ? 'Static' : 'Dynamic'}`];
      turned.Set(x, y, z, w);
      const layer = !box && !ground ? shapeless : fixed ? still : moving;
      const made = new jolt.BodyCreationSettings(shapeOf(body), point(position), turned, motion, layer);
      if (box || ground) made.mFriction = friction, made.mRestitution = restitution;
      if (!fixed) {
        made.mOverrideMassProperties = held;
        made.mMassPropertiesOverride.mMass = mass;
        made.mMassPropertiesOverride.mInertia = jolt.Mat44.prototype.sScaleVec3(vector(inertia));
        made.mLinearDamping = made.mAngularDamping = 0; // 0.05 as shipped
        made.mMaxLinearVelocity = made.mMaxAngularVelocity = 1e10; // 500 m/s, 47 rad/s
        made.mAllowSleeping = false;
        if (flat) made.mAllowedDOFs = jolt.EAllowedDOFs_Plane2D;
        made.mLinearVelocity = vector(velocity), made.mAngularVelocity = vector(spin, 1);
      }
      const created = own.CreateBody(made);
      jolt.destroy(made);
      own.AddBody(created.GetID(), jolt[`EActivation_${fixed ? 'DontActivate' : 'Activate'}`]);
      return created;
    });
    for (const { bodies: [above, below], arms: [first, second] } of pins) {
      const pin = new jolt.PointConstraintSettings();
      pin.mSpace = jolt.EConstraintSpace_LocalToBodyCOM;
      pin.mPoint1 = point(first), pin.mPoint2 = point(second, 1);
      system.AddConstraint(pin.Create(all[above], all[below]));
      jolt.destroy(pin);
    }
    return {
      step: h => world.Step(h, 1),
      bodies: () =>
        all.map((body, i) => {
          const place = numbers(body.GetPosition()), q = body.GetRotation();
          const velocities = bodies[i].fixed
            ? [0, 0, 0, 0, 0, 0]
            : [...numbers(body.GetLinearVelocity()), ...numbers(body.GetAngularVelocity())];
          return [...place, q.GetW(), ...numbers(q), ...velocities];
        }),
      setVelocities: velocities =>
        velocities.forEach((v, i) => {
          if (bodies[i].fixed) return;
          own.SetLinearAndAngularVelocity(all[i].GetID(), vector(v.slice(0, 3)), vector(v.slice(3), 1));
        }),
      free: () => jolt.destroy(world),
    };
  };
}
