# Cost of a contact update over that with `mindlin`, from docs/COST.md; written by make cost.
law_costs = 'linear 0.99  none 0.67  mindlin 1.00  mindlin_scaled 1.04  mindlin_deresiewicz 3.63  randall 6.18  randall_literal 6.29'
