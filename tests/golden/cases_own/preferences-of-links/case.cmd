source agent.soar
run 6
preferences r1
preferences i1
preferences e1
preferences l1
preferences o5
preferences o6
preferences p4
preferences p5
preferences l2
preferences l2 operator
preferences s1 missing
preferences s1 unheard
preferences s1 unseen
preferences s1 item
preferences s2 item
preferences l2 left
preferences --na s1
preferences --t s1
