fof(a, axiom, (a <~> b) & (a ~| b) & (a ~& b) & (a <= b) & ~ ~ (a => b)).
