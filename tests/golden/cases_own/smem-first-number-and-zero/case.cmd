source agent.soar
smem --timers
smem --timers _total
smem --add {(@0 ^a @0) (@0 ^b @0) (<x> ^l @0)}
print @
smem --get initial-variable-id
smem --set initial-variable-id 100
smem --get initial-variable-id
smem --add {(<x> ^a b) (<y> ^c <x>)}
print @
smem --set initial-variable-id 1
smem --add {(<x> ^n 6)}
smem --add {(@1 ^path.place 5)}
print @
print @0
smem --add {(@1 ^|k4| 2)}
print @1
smem --clear
smem --add {(<x> ^n 7)}
print @
