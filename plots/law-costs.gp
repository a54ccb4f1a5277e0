# Cost of a contact update over that with `mindlin`, from docs/COST.md; written by make cost.
law_costs = 'linear 0.93  none 0.64  mindlin 1.00  mindlin_scaled 1.05  mindlin_deresiewicz 3.88  randall 7.58  randall_literal 7.05'
