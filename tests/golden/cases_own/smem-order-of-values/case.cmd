source agent.soar
run 2
print @
print L3 --internal
print --exact (L3 ^* *)
smem --add {(@5 ^a x) (@5 ^a q) (@5 ^a @9) (@5 ^a b) (@5 ^a @2) (@5 ^a zz) (@5 ^b zzz) (@5 ^a zzz)}
print @5
smem --remove {(@5 ^a q)}
print @5
smem --add {(@5 ^a q)}
print @5
