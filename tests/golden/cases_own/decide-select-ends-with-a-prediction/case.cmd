# What `decide select` asks for ends with the first prediction that finds it.
watch 1
decide indifferent-selection --first
sp {a (state <s> ^superstate nil) --> (<s> ^operator <o> + =) (<o> ^name o1)}
sp {b (state <s> ^superstate nil) --> (<s> ^operator <o> + =) (<o> ^name o2)}
sp {c (state <s> ^superstate nil) --> (<s> ^operator <o> + =) (<o> ^name o3)}
run -p 2
decide select o2
decide select
decide predict
decide select
decide predict
run -p 1
decide select
init-soar
run -p 2
decide select o7
decide predict
decide select
run -p 1
decide select
excise a
excise b
decide select o9
run 1
decide predict
decide select
