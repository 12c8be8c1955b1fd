#include "script/schema_keys.hpp"

namespace ashlar::schema {

namespace {

Keys relaxation_keys() {
  return {
      number("tolerance", dimension::none, Range{1e-14, 0.1}, "unbalanced force ratio at which the stage has converged")
          .otherwise(1e-6),
      key("damping", Type::choice, "how motion is taken out on the way to rest; the answer does not depend on it")
          .of({"adaptive", "local", "viscous"})
          .otherwise_text("adaptive"),
      number(
          "damping_value", dimension::none, Range{0, 1, true},
          "local: share of the force (0.8 unless given); viscous: share of velocity lost per step (0.02 unless given)"),
      number("step_factor", dimension::none, Range{0, 1, true}, "scales the pseudo time step").otherwise(1),
      key("max_steps", Type::integer, "gives up after so many relaxation steps; a million unless given"),
      key("start", Type::choice,
          "search: conjugate gradients to the elastic balance before relaxation, where no contact has cracked or "
          "slides; "
          "rest: relaxation alone")
          .of({"search", "rest"})
          .otherwise_text("search"),
  };
}

}  // namespace

/// Stages and how they are solved.
std::vector<NounRule> stage_nouns() {
  return {
      {.name = "static",
       .kind = NounKind::solve,
       .naming = Naming::none,
       .doc = "Equilibrium by dynamic relaxation. What the stage changes (loads, supports, displacements, temperature) "
              "comes in increments where plastic flow or cracking of blocks depends on the path.",
       .keys =
           Keys{key("increments", Type::integer,
                    "equal parts in which the change comes; 20 with a material that remembers, else 1, unless given")} +
           relaxation_keys(),
       .example = R"(stage "gravity" { solve = static { tolerance = 1e-6 } })"},
      {.name = "thermal",
       .kind = NounKind::solve,
       .naming = Naming::none,
       .doc = "Heat: the steady state, or a transient of a given duration, in time steps that the program chooses.",
       .keys =
           {key("steady", Type::flag, "true: the state that the boundary conditions lead to in the end").otherwise(0),
            number("duration", dimension::time, range::positive, "of a transient; give this or `steady = true`"),
            number("record_every", dimension::time, range::positive,
                   "transient: between rows of histories; a hundredth of the duration unless given"),
            number("tolerance", dimension::none, Range{1e-15, 0.1}, "steady: residual over its start")
                .otherwise(1e-10)},
       .example = R"(stage "winter" { solve = thermal { duration = 100*days } })"},
      {.name = "fracture",
       .kind = NounKind::solve,
       .naming = Naming::none,
       .doc = "The temperature change between the ends of two thermal stages, put on the state reached in increments, "
              "with cracks.",
       .keys =
           Keys{key("from", Type::text,
                    "thermal stage whose end is the start; unless given, the temperature of the state reached: that of "
                    "the last stage that balanced stress, the reference temperature before the first"),
                key("to", Type::text, "thermal stage whose end is the goal").need(),
                key("increments", Type::integer, "steps of the load factor from 0 to 1").otherwise(10),
                key("max_events", Type::integer, "gives up after so many crack events").otherwise(100000),
                number("event_group", dimension::none, Range{0.5, 1},
                       "contact points that use at least this share of what the worst one uses of its strength crack "
                       "with it, in one event; less: fewer events and a coarser order of cracks")
                    .otherwise(0.999)} +
           relaxation_keys(),
       .example = R"(stage "fracture" { solve = fracture { from = "summer", to = "winter", increments = 10 } })"},
      {.name = "coupled",
       .kind = NounKind::solve,
       .naming = Naming::none,
       .doc = "Heat and quasi-static stress together in time, such as seasons: heat goes on in its own steps, and at "
              "times `every` apart the body comes to equilibrium with the temperature and the conditions of that "
              "moment, from where the last equilibrium left it. Begins with the equilibrium of its first moment. "
              "Histories have a row for every such time, from the first. On two devices, or beside each other on one: "
              "--devices.",
       .keys = Keys{number("duration", dimension::time, range::positive, "how long").need(),
                    number("every", dimension::time, range::positive,
                           "between equilibria, the last is at the end; a twelfth of the duration unless given"),
                    key("increments", Type::integer,
                        "equal parts in which the change from one equilibrium to the next comes; more than 1 where "
                        "plastic flow or cracking of blocks depends on the path")
                        .otherwise(1)} +
               relaxation_keys(),
       .example = R"(stage "year" { solve = coupled { duration = 365*days, every = 15*days } })"},
      {.name = "strength_reduction",
       .kind = NounKind::solve,
       .naming = Naming::none,
       .doc =
           "The safety factor: by what the strength of all materials and interfaces (cohesion, tan(friction), tensile "
           "strength) can be divided until no equilibrium is found under the loads that act (in 20 000 steps, or "
           "max_steps), by halving the interval. Results show the last state that stands; later stages go on from "
           "before it, with full strength.",
       .keys = Keys{key("between", Type::interval, "{ lowest, highest } factor to look between; { 1, 4 } unless given"),
                    number("width", dimension::none, Range{1e-4, 1}, "of the interval at the end").otherwise(0.01)} +
               relaxation_keys(),
       .example = R"(stage "safety" { solve = strength_reduction { between = { 1, 3 }, width = 0.01 } })"},
      {.name = "dynamic",
       .kind = NounKind::solve,
       .naming = Naming::none,
       .doc = "Motion in time with the real mass, under the loads that act: from rest, or on from a dynamic stage just "
              "before. Explicit: the step is short, the energy balance is kept and reported. Shake a base by "
              "displacement { x = in_stage(...) } on it; or hold it and give gravity { x = in_stage(...) } minus the "
              "base's "
              "acceleration, then displacements are relative to the base.",
       .keys = {number("duration", dimension::time, range::positive, "how long").need(),
                number("mass_damping", dimension::frequency, range::not_negative,
                       "Rayleigh's factor of the mass: 4 pi f xi damps frequency f by xi of critical, lower ones more")
                    .otherwise(0),
                number("stiffness_damping", dimension::time, range::not_negative,
                       "Rayleigh's factor of the blocks' stiffness: xi / (pi f) damps frequency f by xi of critical, "
                       "higher ones more; shortens the step")
                    .otherwise(0),
                number("local_damping", dimension::none, Range{0, 0.95},
                       "share of the unbalanced force that opposes motion; 0.1 is about 3 % of critical at every "
                       "frequency")
                    .otherwise(0),
                number("record_every", dimension::time, range::positive,
                       "between rows of histories; a hundredth of the duration unless given"),
                number("time_step", dimension::time, range::positive,
                       "longest step; refused above the stable one; chosen unless given"),
                number(
                    "time_factor", dimension::none, Range{0, 10, true},
                    "share of the stable step to take; 0.9 unless given, about half of that where contacts may open or "
                    "slide, which close to the stable step draw energy from nothing; above 1 to see a motion run "
                    "away"),
                key("large_displacement", Type::flag,
                    "true: blocks move and turn as far as they like, part, fall and meet others. Whatever two regions "
                    "a frictional joint or crackable names touch wherever they meet (blocks of one region as the first "
                    "joint of that region says): nodes of either on faces of the other and sharp edges across each "
                    "other. Where faces lie on each other the side with the smaller ones bears, equal ones half each. "
                    "Loads keep their direction; stress is given in axes that turn with the body, and interface "
                    "results show nothing. Later stages have "
                    "to be of this kind too")
                    .otherwise(0),
                number("contact_damping", dimension::time, range::not_negative,
                       "large_displacement: contacts also resist their speed, by their stiffness times this; "
                       "xi / (pi f) damps a block that bounces on them at frequency f by xi of critical; shortens the "
                       "step")
                    .otherwise(0)},
       .example =
           R"(stage "release" { solve = dynamic { duration = 2*s, mass_damping = 0.5/s, record_every = 0.01*s } })"},
      {.name = "stage",
       .doc = "One step of the model's life. Stages continue from each other, in the deck's order.",
       .keys =
           {key("solve", Type::solve,
                "static {...}, thermal {...}, fracture {...}, coupled {...}, dynamic {...} or strength_reduction {...}")
                .need(),
            key("apply", Type::conditions,
                "conditions that act from this stage on: a list of calls such as convection {...}. One replaces an "
                "earlier one of its noun on the same surface"),
            key("remove", Type::names, "names of conditions that stop acting"),
            key("reset_displacement", Type::flag, "true: results count displacement from the end of this stage")
                .otherwise(0)},
       .example =
           R"(stage "summer" { apply = { fixed_temperature { surface = "top", value = 20*degC } }, solve = thermal { steady = true } })"},
  };
}

}  // namespace ashlar::schema
