cnf(f1, axiom, floor(1, 'floor1.png', 0.05)).
cnf(l1, axiom, landmark(a, 1, 2.0 3.0)).
cnf(l2, axiom, landmark(b, 1, X, 3.0)).
