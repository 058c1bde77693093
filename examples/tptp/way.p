% A way from landmark a to some landmark near an elevator.
fof(door_ab, axiom, edge(a, b)).
fof(door_bc, axiom, edge(b, c)).
fof(door_bd, axiom, edge(b, d)).
fof(door_de, axiom, edge(d, e)).
fof(elevator, axiom, near_elevator(e)).
fof(one_step, axiom, ! [X, Y] : (edge(X, Y) => way(X, Y))).
fof(more_steps, axiom, ! [X, Y, Z] : ((edge(X, Y) & way(Y, Z)) => way(X, Z))).
fof(goal, conjecture, ? [X] : (way(a, X) & near_elevator(X))).
