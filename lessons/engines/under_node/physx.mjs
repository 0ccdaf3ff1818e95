// PhysX. Modes: TGS and PGS, its solvers of rows; articulation, trees of coordinates that cannot part.
import { readFile } from 'node:fs/promises';

export async function load(modules) {
  const folder = `${modules}/node_modules/physx-js-webidl/physx-js-webidl`;
  const wasmBinary = await readFile(`${folder}.wasm`);
  // It is built for browsers, and refuses node by its name.
  const { process } = globalThis;
  Object.assign(globalThis, { process: undefined, window: globalThis });
  const px = await (await import(`${folder}.mjs`)).default({ wasmBinary });
  Object.assign(globalThis, { process, window: undefined });

  const top = px.PxTopLevelFunctions.prototype, version = top.PHYSICS_VERSION, scale = new px.PxTolerancesScale();
  const foundation = top.CreateFoundation(version, new px.PxDefaultAllocator(), new px.PxDefaultErrorCallback());
  const physics = top.CreatePhysics(version, foundation, scale);
  top.InitExtensions(physics);
  const dispatcher = top.DefaultCpuDispatcherCreate(0);

  const everybody = new px.PxFilterData(1, 1, 0, 0); // is met by everybody

  // Arguments are filled anew for each call.
  const argument = new px.PxVec3(0, 0, 0), frames = [1, 2].map(() => new px.PxTransform(px.PxIDENTITYEnum.PxIdentity));
  const vector = ([x, y, z], to = argument) => Object.assign(to, { x, y, z });
  const frame = (k, p, [w, x, y, z]) => {
    vector(p, frames[k].p), Object.assign(frames[k].q, { w, x, y, z });
    return frames[k];
  };
  const numbers = ({ x, y, z }) => [x, y, z];
  const still = [1, 0, 0, 0], hinge = [Math.SQRT1_2, 0, -Math.SQRT1_2, 0]; // turns x, a hinge's axis, into z

  return ({ scene: { flat, gravity, bodies, pins }, mode, knob }) => {
    const descriptor = new px.PxSceneDesc(scale);
    descriptor.gravity = vector(gravity);
    descriptor.cpuDispatcher = dispatcher;
    descriptor.filterShader = top.DefaultFilterShader();
    descriptor.solverType = px.PxSolverTypeEnum[mode === 'PGS' ? 'ePGS' : 'eTGS'];
    const scene = physics.createScene(descriptor);
    px.destroy(descriptor);
    const iterations = knob('iterations', 4);

    const shape = (actor, { box, friction, restitution }) => {
      const geometry = box ? new px.PxBoxGeometry(...box.map(side => side / 2)) : new px.PxPlaneGeometry();
      const material = physics.createMaterial(friction, friction, restitution);
      const made = px.PxRigidActorExt.prototype.createExclusiveShape(actor, geometry, material);
      made.setSimulationFilterData(everybody);
      px.destroy(geometry), material.release();
    };
    const weigh = (body, { mass, inertia }) => {
      body.setMass(mass), body.setMassSpaceInertiaTensor(vector(inertia));
      body.setLinearDamping(0), body.setAngularDamping(0); // 0 and 0.05 as shipped
      body.setMaxAngularVelocity(1e10); // 100 rad/s
      body.setSleepThreshold?.(0);
    };
    const added = [];
    const add = actor => (scene.addActor(actor), added.push(actor), actor);
    const inTree = i => mode === 'articulation' && pins.some(({ bodies: [, below] }) => below === i);
    const actors = bodies.map((body, i) => {
      const { fixed, ground, box, position, rotation } = body;
      if (inTree(i)) return null;
      const place = frame(0, position, ground ? toNormal(ground) : rotation);
      const actor = physics[fixed ? 'createRigidStatic' : 'createRigidDynamic'](place);
      if (box || ground) shape(actor, body);
      if (!fixed) {
        weigh(actor, body);
        actor.setSolverIterationCounts(iterations);
        for (const axis of flat ? ['LINEAR_Z', 'ANGULAR_X', 'ANGULAR_Y'] : [])
          actor.setRigidDynamicLockFlag(px.PxRigidDynamicLockFlagEnum[`eLOCK_${axis}`], true);
        actor.setLinearVelocity(vector(body.velocity)), actor.setAngularVelocity(vector(body.spin));
      }
      return add(actor);
    });

    const trees = new Map(); // by the fixed body they hang from: its articulation and its link
    const treeAt = root => {
      if (!trees.has(root)) {
        const tree = physics.createArticulationReducedCoordinate();
        tree.setArticulationFlag(px.PxArticulationFlagEnum.eFIX_BASE, true);
        tree.setSolverIterationCounts(iterations), tree.setSleepThreshold(0);
        trees.set(root, { tree, link: tree.createLink(null, frame(0, bodies[root].position, bodies[root].rotation)) });
      }
      return trees.get(root);
    };
    const joints = [], links = []; // and the links by body
    for (const { bodies: [above, below], arms } of pins) {
      const [frame0, frame1] = arms.map((arm, k) => frame(k, arm, flat ? hinge : still));
      if (mode !== 'articulation') {
        const create = flat ? 'RevoluteJointCreate' : 'SphericalJointCreate';
        joints.push(top[create](physics, actors[above], frame0, actors[below], frame1));
        continue;
      }
      const { tree, link } = links[above] ?? treeAt(above), { position, rotation } = bodies[below];
      const child = (actors[below] = tree.createLink(link, frame(0, position, rotation)));
      weigh(child, bodies[below]);
      links[below] = { tree, link: child };
      const joint = child.getInboundJoint(), axis = px.PxArticulationAxisEnum;
      joint.setJointType(px.PxArticulationJointTypeEnum[flat ? 'eREVOLUTE' : 'eSPHERICAL']);
      for (const name of flat ? ['eTWIST'] : ['eTWIST', 'eSWING1', 'eSWING2'])
        joint.setMotion(axis[name], px.PxArticulationMotionEnum.eFREE);
      // Its angle is zero where both frames are one: at first.
      const now = times(rotation, flat ? hinge : still);
      joint.setParentPose(frame(0, arms[0], times(conjugate(bodies[above].rotation), now)));
      joint.setChildPose(frame(1, arms[1], flat ? hinge : still));
      joint.setMaxJointVelocity(1e10); // 100 rad/s as shipped
      joint.setFrictionCoefficient(knob('joint friction', 0)); // 0.05 as shipped
    }
    for (const { tree } of trees.values()) scene.addArticulation(tree);

    const moving = bodies.map(({ fixed }, i) => (fixed ? null : actors[i]));
    return {
      step: h => (scene.simulate(h), scene.fetchResults(true)),
      bodies: () =>
        bodies.map(({ position, rotation }, i) => {
          if (!moving[i]) return [...position, ...rotation, 0, 0, 0, 0, 0, 0];
          const { p, q } = moving[i].getGlobalPose(), place = [...numbers(p), q.w, ...numbers(q)];
          return [...place, ...numbers(moving[i].getLinearVelocity()), ...numbers(moving[i].getAngularVelocity())];
        }),
      setVelocities: all =>
        all.forEach((v, i) => {
          if (!moving[i] || links[i]) return;
          moving[i].setLinearVelocity(vector(v.slice(0, 3))), moving[i].setAngularVelocity(vector(v.slice(3)));
        }),
      free: () => {
        for (const one of [...joints, ...[...trees.values()].map(({ tree }) => tree), ...added, scene]) one.release();
      },
    };
  };
}

/// Turns x into a unit vector n, not −x: the outer normal of a plane.
const toNormal = ([x, y, z]) => [1 + x, 0, -z, y].map(part => part / Math.sqrt(2 + 2 * x));
const conjugate = ([w, x, y, z]) => [w, -x, -y, -z];
const times = ([a, b, c, d], [w, x, y, z]) => [
  a * w - b * x - c * y - d * z,
  a * x + b * w + c * z - d * y,
  a * y - b * z + c * w + d * x,
  a * z + b * y - c * x + d * w,
];
