//! Rapier in the plane with double precision (rapier2d-f64): a ball on a half plane, its mass
//! properties set.
//!
//! engine: Rapier
//! contact: rigid
//! settings: default careful
//! requires: cargo:rapier
//! limits: own_turn=0.785/step turn=0.785/step own_speed=400 speed=400 sleep=0.03 friction=mean
//!   force=1.00,+0 rolling=none rolling_small=none rolling_slow=none
//! docs: https://rapier.rs/docs/
//!
//! default: as the crate comes. Its contact is a spring, critically damped tenfold, of 60 Hz
//! against a fixed body.
//! careful: a contact whose frequency is an eighth of that of the steps, damped fivefold; friction
//! is solved together with the correction of overlaps; no contact is recycled.
//! Cannot express: mu_s and mu_k (one coefficient; both shapes have the same). Restitution acts at
//! any speed, but without friction: the crate applies it at the end of a step, along the normal
//! alone.

use std::error::Error;
use std::fmt::Write;

use cpu_time::ProcessTime;
use rapier2d_f64::na::Unit;
use rapier2d_f64::prelude::*;

/// Time between two rows, at least; adapter.py has it, too.
const SHORTEST: f64 = 1e-4;
const REFUSED: i32 = 3;

/// The numbers of a case file.
struct Case(serde_json::Value);

impl Case {
    fn get(&self, name: &str) -> Result<f64, String> {
        self.0[name].as_f64().ok_or_else(|| format!("the case has no number {name}"))
    }

    /// Whether the case has a mark of a probe.
    fn is(&self, name: &str) -> bool {
        self.0[name].as_bool().unwrap_or(false)
    }

    /// The units of length, mass and time, in those of the engine.
    fn units(&self) -> Result<(f64, f64, f64), String> {
        let radius = self.get("radius")?;
        Ok((radius, self.get("unit_of_mass")?, (radius / self.get("g")?).sqrt()))
    }
}

/// A world with the hoop, which starts.
fn world(case: &Case, step: f64, is_careful: bool) -> Result<(PhysicsWorld, RigidBodyHandle), String> {
    let mut world = PhysicsWorld::default();
    let (radius, mass, second) = case.units()?;
    let (slope, g) = (case.get("slope")?, case.get("g")?);
    world.gravity = Vector::new(-g * slope.sin(), -g * slope.cos());
    let with = &mut world.integration_parameters;
    with.dt = step;
    if is_careful {
        with.static_contact_softness = SpringCoefficients::new(0.125 / step, 5.0);
        with.friction_in_bias_pass = true;
        with.contact_recycling = false;
    }
    let (h, theta, rate) = (case.get("h")? * radius, case.get("theta")?, case.get("theta_rate")? / second);
    let (mu, restitution) = (case.get("mu_k")?, case.get("restitution")?);
    let ground = case.get("plane").ok().filter(|&other| other >= 0.0).unwrap_or(mu);
    let plane =
        ColliderBuilder::halfspace(Unit::new_unchecked(Vector::Y)).friction(ground).restitution(restitution);
    world.insert(RigidBodyBuilder::fixed(), plane);
    let body = RigidBodyBuilder::dynamic()
        .can_sleep(case.is("is_untouched"))
        .translation(Vector::new(0.0, radius))
        .rotation(theta)
        .additional_mass_properties(MassProperties::new(
            Vector::new(0.0, h),
            case.get("mass")? * mass,
            case.get("inertia")? * mass * radius * radius,
        ))
        // The velocity is that of the mass centre.
        .linvel(Vector::new(
            case.get("slip")? * radius / second - rate * (radius + h * theta.cos()),
            case.get("gap_rate")? * radius / second - rate * h * theta.sin(),
        ))
        .angvel(rate);
    let rim = ColliderBuilder::ball(radius).density(0.0).friction(mu).restitution(restitution);
    let (hoop, _) = world.insert(body, rim);
    Ok((world, hoop))
}

fn main() -> Result<(), Box<dyn Error>> {
    let [file, step, setting, out] = std::array::from_fn(|i| std::env::args().nth(i + 1).unwrap_or_default());
    let case = Case(serde_json::from_str(&std::fs::read_to_string(file)?)?);
    let step: f64 = step.parse()?;
    let (mu_s, mu_k) = (case.get("mu_s")?, case.get("mu_k")?);
    if mu_s != mu_k {
        eprintln!("the engine has one coefficient of friction, the case mu_s = {mu_s}, mu_k = {mu_k}");
        std::process::exit(REFUSED);
    }
    let resistance = case.get("rolling_resistance")?;
    if resistance != 0.0 {
        eprintln!("the adapter sets up no rolling friction, the case chi = {resistance}");
        std::process::exit(REFUSED);
    }
    let (radius, mass, second) = case.units()?;
    let (velocity, weight) = (radius / second, mass * case.get("g")?);
    let (mut world, hoop) = world(&case, step * second, setting == "careful")?;
    let (h, has_force) = (case.get("h")? * radius, case.is("has_force"));
    let mut turned = case.get("theta")?;
    let mut rows = String::from("time,x,y,theta,x_rate,y_rate,theta_rate");
    rows.push_str(if has_force { ",force\n" } else { "\n" });
    let mut row = |time: f64, world: &PhysicsWorld| {
        let (place, angle) = (world.bodies[hoop].translation(), world.bodies[hoop].rotation().angle());
        let tau = std::f64::consts::TAU;
        turned += angle - turned - tau * ((angle - turned) / tau).round();
        let (v, rate) = (world.bodies[hoop].linvel(), world.bodies[hoop].angvel());
        // From the velocity of the mass centre to that of the geometric centre.
        let (along, up) = (v.x + h * turned.cos() * rate, v.y + h * turned.sin() * rate);
        write!(rows, "{time},{},{},{turned}", place.x / radius, place.y / radius)?;
        write!(rows, ",{},{},{}", along / velocity, up / velocity, rate * second)?;
        if has_force {
            let pushed: f64 = world
                .narrow_phase
                .contact_pairs()
                .flat_map(|pair| pair.manifolds())
                .flat_map(|manifold| &manifold.points)
                .map(|point| point.data.impulse)
                .sum();
            write!(rows, ",{}", pushed / (step * second) / weight)?;
        }
        writeln!(rows)
    };
    let count = (case.get("until")? / step).round() as u64;
    let each = ((SHORTEST / step).round() as u64).max(1);
    row(0.0, &world)?;
    let start = ProcessTime::now();
    for i in 1..=count {
        world.step();
        if i % each == 0 {
            row(i as f64 * step, &world)?;
        }
    }
    let cost = start.elapsed().as_secs_f64();
    std::fs::write(out, rows)?;
    println!("{{\"cpu_s\": {cost}, \"steps\": {count}}}");
    Ok(())
}
