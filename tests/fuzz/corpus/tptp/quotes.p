fof('A name', axiom, 'P'('it\'s', 'back\\slash', "a \"b\"", 'café')).
