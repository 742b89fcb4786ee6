/* planck (Box2D for JavaScript, in double precision): a body whose mass data are set, a circle, a long edge.

engine: planck (Box2D, double precision)
contact: rigid
settings: default careful
requires: npm:planck==1.5.0
limits: own_turn=1.57/step turn=1.57/step own_speed=2/step speed=2/step sleep=0.01 friction=root
  force=1.00,+0 rolling=none rolling_small=none rolling_slow=none
limits default: bounce=1.05
docs: https://piqnt.com/planck.js/

default: R is 1 m; 8 velocity and 3 position iterations, a slop of 0.005 m.
careful: a slop of 1e-6 m, which double precision allows, 100 and 100 iterations, restitution at any speed.
Cannot express: mu_s and mu_k (one coefficient; that of two shapes is the root of the product of theirs). Restitution
acts above 1 m/s by default. An edge has a skin of twice the slop: it lies lower by that. */
"use strict";
const planck = require("planck");
const { centreRates, frictionOfPlane, main, massCentre, oneCoefficient } = require("./adapter.cjs");

const SETTINGS = { default: [0.005, 1, 8, 3], careful: [1e-6, 0, 100, 100] };

main((hoop, step, setting) => {
  const [slop, threshold, velocities, positions] = SETTINGS[setting];
  planck.Settings.linearSlop = slop;
  planck.Settings.velocityThreshold = threshold;
  const friction = oneCoefficient(hoop);
  const { g, radius } = hoop;
  const gravity = { x: -g * Math.sin(hoop.slope), y: -g * Math.cos(hoop.slope) };
  const world = new planck.World({ gravity, allowSleep: Boolean(hoop.is_untouched) });
  const skin = 2 * slop;
  const edge = new planck.Edge({ x: -100 * radius, y: -skin }, { x: 100 * radius, y: -skin });
  world.createBody().createFixture({ shape: edge, friction: frictionOfPlane(hoop, friction) });
  // The origin of the body is the geometric centre, about which planck takes the inertia.
  const body = world.createBody({ type: "dynamic", position: { x: 0, y: radius }, angle: hoop.theta });
  body.createFixture({ shape: new planck.Circle(radius), density: 1, friction, restitution: hoop.restitution });
  body.setMassData({ mass: hoop.mass, center: { x: 0, y: hoop.h }, I: hoop.inertia + hoop.mass * hoop.h ** 2 });
  const { vx, vy } = massCentre(hoop);
  body.setLinearVelocity({ x: vx, y: vy });
  body.setAngularVelocity(hoop.theta_rate);
  let pushed = 0;
  world.on("post-solve", (_, impulse) => (pushed = impulse.normalImpulses.reduce((a, b) => a + b, 0)));
  return {
    advance: () => {
      pushed = 0;
      world.step(step, velocities, positions);
    },
    row: () => {
      const at = body.getPosition();
      const { x, y } = body.getLinearVelocity();
      const rates = centreRates(hoop, body.getAngle(), x, y, body.getAngularVelocity());
      return [at.x, at.y, body.getAngle(), ...rates, ...(hoop.has_force ? [pushed / step] : [])];
    },
  };
});
