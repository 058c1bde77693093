cnf(f1, axiom, floor(1, 'nowhere.png', 0.05)).
cnf(l1, axiom, landmark(a, 1, 2.0, 3.0)).
cnf(a1, axiom, adjacent(a, b)).
