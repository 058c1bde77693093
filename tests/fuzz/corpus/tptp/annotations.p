fof(n, axiom, p, inference(r,[status(thm),bind(X,$fot(f(X)))],[a:[b],'c']),[x,$fof(p&q)]).
cnf(m, axiom-local, p, file('a.p',n), [x]).
