// Whether only some of what takes long is tried: ./tests/run --site=quick.
export const quick = !!process.env.BYHAND_QUICK;

// What is tried of many: all, or in a quick run each `of`-th, from one on that the last commit draws.
export const drawn = (all, of) => quick ? all.filter((_, i) => (i + Number(process.env.BYHAND_DRAWN ?? 0)) % of === 0) : all;
