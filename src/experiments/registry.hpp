#pragma once

/// All experiments, in the order of the manual and of their tables in the case file: a line for each folder, NAME, in
/// which NAME_experiment() says what its command is and NAME_settings() what its table of the case file is. They are
/// told apart because the page of the designer reads case files without running all that may be in them. What optimise
/// runs are others, and ensembles: its run is in a module above them, optimise/.
#define BUMPFOIL_EXPERIMENTS(EACH) \
  EACH(cycle)                      \
  EACH(strip)                      \
  EACH(path)                       \
  EACH(vibration)                  \
  EACH(film)                       \
  EACH(equilibrium)                \
  EACH(stability)                  \
  EACH(unbalance)                  \
  EACH(transient)                  \
  EACH(fit)                        \
  EACH(optimise)
