source agent.soar
run 1
run 1
print (* ^success *)
print (* ^bad-cmd *)
print (* ^failure *)
smem --stats stores
run 1
print (* ^success *)
print (* ^bad-cmd *)
print (* ^failure *)
smem --stats stores
run 1
print (* ^success *)
print (* ^bad-cmd *)
print (* ^failure *)
smem --stats stores
run 1
print (* ^success *)
print (* ^bad-cmd *)
print (* ^failure *)
smem --stats stores
run 1
print (* ^success *)
print (* ^bad-cmd *)
print (* ^failure *)
smem --stats stores
run 1
print (* ^success *)
print (* ^bad-cmd *)
print (* ^failure *)
smem --stats stores
run 1
print (* ^success *)
print (* ^bad-cmd *)
print (* ^failure *)
smem --stats stores
run 1
print (* ^success *)
print (* ^bad-cmd *)
print (* ^failure *)
smem --stats stores
run 1
print (* ^success *)
print (* ^bad-cmd *)
print (* ^failure *)
smem --stats stores
run 1
print (* ^success *)
print (* ^bad-cmd *)
print (* ^failure *)
smem --stats stores
print -d 2 s1
