source agent.soar
smem --query {(<x> ^a b)} 0
smem --query {(<x> ^a b)} x
smem --query {(<x> ^a b)} 2 3
smem --query {(<x> ^link @99)}
smem --query {(<x> ^a b) (<y> ^n 8)}
smem --query {(<x> ^a b) (<x> ^n)}
smem --query {(<x> -^n 5)}
smem --query {(<x> ^a b -^n 5)}
smem --query {(<x> ^a b) and more}
smem --query {(@1 ^a b)}
smem --query {}
smem --remove {(@1 ^n 99)}
smem --remove {(@1 ^n 99 5)}
print @1
smem --remove {(@1 ^zz q)}
smem --remove {(@1 ^zz ^n 6)} force
print @1
smem --remove {(@9 ^a b)} force
smem --remove {(@2 ^a b) (@1 ^a b)}
print @
smem --remove {(@2)} sure
smem --remove {}
smem --add {(@1)}
smem --add {(@30 ^a b)(@31 ^c d)(@32 ^e)}
smem --add {(@33 ^a b) and more}
print @
smem --export
smem --history @77
smem --clear all
