#pragma once

/// All experiments, in the order of the manual and of their tables in the case file: one line per folder, NAME.
/// NAME_experiment() describes its command and NAME_settings() its table of the case file. They are separate because
/// the designer page reads case files without linking all experiments. The run of optimise is in a higher module,
/// optimise/, as it runs other experiments and ensembles.
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
