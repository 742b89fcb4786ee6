"""The library's errors at events of random motions of the whole accepted range.

They are measured against 60 digits.

    python3 -m accuracy                    writes accuracy.json beside this package, and table and
    picture of docs/accuracy.md python3 -m accuracy --motions 200      so many of either kind;
    prints, writes nothing python3 -m accuracy --page             picture and page again from
    accuracy.json

Needs gmpy2, python-flint and cargo, for the page Matplotlib and the Python package `littlewood`.

Half of the motions are drawn from all that is accepted, half from usual ranges, by the crate
`littlewood-random`.  The package `follower` repeats the motion with 60 digits, and a few times with
every number of the hoop, of the start and of the state at the start of each phase changed by 2^-52
of itself, up or down.  Of each number at each event there is then

- its error in units of 2^-52 of itself (of a place, at least of the radius), and
- its conditioning: the largest change among the repetitions, in the same unit, but at least one
  unit.  A number cannot be
  known better from doubles.

From the first event on at which a repetition takes another course the doubles do not decide the
motion; there it ends here.  It also ends where the follower gives up: after MOST events, after so
many steps of a phase, where bounces settle.
"""
