/* planck (Box2D for JavaScript, in double precision): a body whose mass data are set, a circle, a long edge.

engine: planck (Box2D, double precision)
contact: rigid
settings: default careful
requires: npm:planck==1.5.0
docs: https://piqnt.com/planck.js/

default: R is 1 m; 8 velocity and 3 position iterations, a slop of 0.005 m.
careful: a slop of 1e-6 m, which double precision allows, 100 and 100 iterations, restitution at any speed.
Cannot express: mu_s and mu_k (one coefficient; that of two shapes is the root of the product of theirs). Restitution
acts above 1 m/s by default. An edge has a skin of twice the slop: it lies lower by that. */
"use strict";
const planck = require("planck");
const { main, massCentre, oneCoefficient } = require("./adapter.cjs");

const SETTINGS = { default: [0.005, 1, 8, 3], careful: [1e-6, 0, 100, 100] };

main((hoop, step, setting) => {
  const [slop, threshold, velocities, positions] = SETTINGS[setting];
  planck.Settings.linearSlop = slop;
  planck.Settings.velocityThreshold = threshold;
  const friction = oneCoefficient(hoop);
  const world = new planck.World({ gravity: { x: -Math.sin(hoop.slope), y: -Math.cos(hoop.slope) }, allowSleep: false });
  const skin = 2 * slop;
  world.createBody().createFixture({ shape: new planck.Edge({ x: -100, y: -skin }, { x: 100, y: -skin }), friction });
  // The origin of the body is the geometric centre, about which planck takes the inertia.
  const body = world.createBody({ type: "dynamic", position: { x: 0, y: 1 }, angle: hoop.theta });
  body.createFixture({ shape: new planck.Circle(1), density: 1, friction, restitution: hoop.restitution });
  body.setMassData({ mass: hoop.mass, center: { x: 0, y: hoop.h }, I: hoop.inertia + hoop.mass * hoop.h ** 2 });
  const { vx, vy } = massCentre(hoop);
  body.setLinearVelocity({ x: vx, y: vy });
  body.setAngularVelocity(hoop.theta_rate);
  return {
    advance: () => world.step(step, velocities, positions),
    place: () => [body.getPosition().x, body.getPosition().y, body.getAngle()],
  };
});
