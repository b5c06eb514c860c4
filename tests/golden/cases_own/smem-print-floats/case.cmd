smem --enable
smem --add {(@9 ^a 1.5 ^c 1234567.25 0.000012345 1.0 ^b @8) (@8 ^x 3.5)}
print @9 -d 2
print @9 -d 2
smem --history @9
