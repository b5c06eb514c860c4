source agent.soar
run 6
print -s -d 2
print --stack --tree
print -s -o
print --stack --internal
print -a -d 2
print -d 1.5 s1
print -d x s1
print -depth 0 -internal
print (* ^label |red box|)
print {(* ^label |red box|)}
print |no such rule|
print |unseen|
print -v s1
varprint s1
varprint
print ""
print (* ^note *)
