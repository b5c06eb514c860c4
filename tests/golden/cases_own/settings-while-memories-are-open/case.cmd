smem --set cache-size 100
smem --clear
smem --enable
smem --clear
smem --add {(@1 ^a b ^n 3.25)}
smem --set cache-size 200
smem --set cache-size x
smem --set page-size 4k
smem --set page-size 5k
smem --set lazy-commit off
smem --set optimization safety
smem --set thresh 3
smem --get cache-size
smem --disable
smem --clear
epmem --set cache-size 100
epmem --enable
run 1
epmem --set lazy-commit off
epmem --set page-size 4k
epmem --set page-size 5k
epmem --set cache-size 100
epmem --set optimization safety
epmem --close
epmem --set page-size 4k
epmem --get page-size
