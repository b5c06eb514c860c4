source agent.soar
run 4
print @
run 5
print @
smem --add {(@1 ^e @15 (2)) (@15 ^n 15)}
run 2
print @
smem --add {(@7 ^a @2 (x) ^b 3)}
smem --add {(@7 ^a @3 (1 ^b 3)}
smem --add {(@7 ^b 4 (2))}
print @7
