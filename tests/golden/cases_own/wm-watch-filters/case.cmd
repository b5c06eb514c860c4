source agent.soar
run 2
wm watch -a
wm watch -a s1 count *
wm watch -a -t some s1 count *
wm watch -a -t adds s1 count
wm watch -a -t adds s9 count *
wm watch -a -t adds s1 count *
wm watch -a -t adds s1 count *
wm watch -a -t both * name *
wm watch -l
wm watch -l -t removes
run 1
trace -w
run 1
wm watch -r -t both s1 count *
wm watch -r -t adds s1 count *
wm watch -r count
trace -w remove
run 1
wm watch -R -t adds
wm watch -R -t adds
wm watch -l
wm watch s1 count *
