// What the adapters for node share: adapter.py says what they read and write.
"use strict";
const fs = require("node:fs");

const SHORTEST = 1e-4;
const REFUSED = 3;

/** The coefficient of friction, for an engine that has one. */
function oneCoefficient(hoop) {
  if (hoop.mu_s !== hoop.mu_k) {
    console.error(`the engine has one coefficient of friction, the case mu_s = ${hoop.mu_s}, mu_k = ${hoop.mu_k}`);
    process.exit(REFUSED);
  }
  return hoop.mu_k;
}

/** Place and velocity of the mass centre at the start. */
function massCentre(hoop) {
  const c = hoop.h * Math.cos(hoop.theta);
  const s = hoop.h * Math.sin(hoop.theta);
  const rate = hoop.theta_rate;
  return { x: -s, y: 1 + c, vx: hoop.slip - rate - c * rate, vy: hoop.gap_rate - s * rate };
}

/** Runs one case: `prepare(hoop, step, setting)` returns `advance()` and `place()`, which gives [x, y, theta]. */
function main(prepare) {
  const [file, text, setting, out] = process.argv.slice(2);
  const hoop = JSON.parse(fs.readFileSync(file, "utf8"));
  const step = Number(text);
  const { advance, place } = prepare(hoop, step, setting);
  const count = Math.round(hoop.until / step);
  const each = Math.max(1, Math.round(SHORTEST / step));
  const rows = ["time,x,y,theta", [0, ...place()].join()];
  const before = process.cpuUsage();
  for (let i = 1; i <= count; i++) {
    advance();
    if (i % each === 0) rows.push([i * step, ...place()].join());
  }
  const { user, system } = process.cpuUsage(before);
  fs.writeFileSync(out, rows.join("\n") + "\n");
  console.log(JSON.stringify({ cpu_s: (user + system) * 1e-6, steps: count }));
}

module.exports = { main, massCentre, oneCoefficient };
