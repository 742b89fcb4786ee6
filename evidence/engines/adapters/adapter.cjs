// What the adapters for node share: adapter.py says what they read and write.
"use strict";
const fs = require("node:fs");

const SHORTEST = 1e-4;
const REFUSED = 3;
const COLUMNS = ["time", "x", "y", "theta", "x_rate", "y_rate", "theta_rate", "force"];

function refuse(reason) {
  console.error(reason);
  process.exit(REFUSED);
}

/** The case of a file, in the units of the engine. */
function read(file) {
  const given = JSON.parse(fs.readFileSync(file, "utf8"));
  const second = Math.sqrt(given.radius / given.g);
  const velocity = given.radius / second;
  return {
    ...given,
    mass: given.mass * given.unit_of_mass,
    h: given.h * given.radius,
    inertia: given.inertia * given.unit_of_mass * given.radius ** 2,
    theta_rate: given.theta_rate / second,
    slip: given.slip * velocity,
    gap_rate: given.gap_rate * velocity,
    until: given.until * second,
    second,
    velocity,
  };
}

/** The coefficient of friction, for an engine that has one. */
function oneCoefficient(hoop) {
  if (hoop.mu_s !== hoop.mu_k) {
    refuse(`the engine has one coefficient of friction, the case mu_s = ${hoop.mu_s}, mu_k = ${hoop.mu_k}`);
  }
  return hoop.mu_k;
}

/** The coefficient of the plane: `neutral`, but in a probe. */
function frictionOfPlane(hoop, neutral) {
  return hoop.plane >= 0 ? hoop.plane : neutral;
}

/** Place and velocity of the mass centre at the start. */
function massCentre(hoop) {
  const c = hoop.h * Math.cos(hoop.theta);
  const s = hoop.h * Math.sin(hoop.theta);
  const rate = hoop.theta_rate;
  const along = hoop.slip - hoop.radius * rate;
  return { x: -s, y: hoop.radius + c, vx: along - c * rate, vy: hoop.gap_rate - s * rate };
}

/** x', y' of the geometric centre and theta' from the velocity of the mass centre. */
function centreRates(hoop, theta, vx, vy, rate) {
  return [vx + hoop.h * Math.cos(theta) * rate, vy + hoop.h * Math.sin(theta) * rate, rate];
}

/**
 * Runs one case: `prepare(hoop, step, setting)` returns `advance()` and `row()`, which gives [x, y, theta, x', y',
 * theta'], and where `hoop.has_force` the normal force.
 */
function main(prepare) {
  const [file, text, setting, out] = process.argv.slice(2);
  const hoop = read(file);
  if (hoop.rolling_resistance !== 0) {
    refuse(`the adapter sets up no rolling friction, the case chi = ${hoop.rolling_resistance}`);
  }
  const step = Number(text) * hoop.second;
  const { advance, row } = prepare(hoop, step, setting);
  const count = Math.round(hoop.until / step);
  const each = Math.max(1, Math.round((SHORTEST * hoop.second) / step));
  const rows = [[0, ...row()]];
  const before = process.cpuUsage();
  for (let i = 1; i <= count; i++) {
    advance();
    if (i % each === 0) rows.push([i * step, ...row()]);
  }
  const { user, system } = process.cpuUsage(before);
  const { second, velocity, radius } = hoop;
  const weight = hoop.unit_of_mass * hoop.g;
  const units = [second, radius, radius, 1, velocity, velocity, 1 / second, weight];
  const lines = rows.map((one) => one.map((value, i) => value / units[i]).join());
  fs.writeFileSync(out, [COLUMNS.slice(0, rows[0].length).join(), ...lines, ""].join("\n"));
  console.log(JSON.stringify({ cpu_s: (user + system) * 1e-6, steps: count }));
}

module.exports = { centreRates, frictionOfPlane, main, massCentre, oneCoefficient };
