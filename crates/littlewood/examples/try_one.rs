//! x
use littlewood::*;
fn main() {
    let a: Vec<f64> = std::env::args().skip(1).map(|x| x.parse().unwrap()).collect();
    let hoop = Hoop::new(
        HoopParameters::new(a[0], 1.0, a[0])
            .with_friction(a[1], a[2])
            .with_restitution(a[3], RestitutionLaw::Energetic),
    )
    .unwrap();
    let m = hoop
        .simulate(Start::at(a[4], a[5]).with_slip(a[6]), Limits::until(60.0).with_transitions(20))
        .unwrap();
    for t in m.transitions() {
        println!(
            "{:.17} {:?}->{:?} {} th {:.15} rate {:.15} slip {:.15} {:?}",
            t.after.time,
            t.from,
            t.to,
            t.cause,
            t.after.theta,
            t.after.theta_rate,
            t.after.slip,
            t.impact.map(|i| (i.case, i.before.slip, i.after.gap_rate, i.energy_lost()))
        );
    }
    println!("{:?}\n", m.outcome());
}
