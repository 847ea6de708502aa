function [c, slope, integral, muscle] = mckibben_coefficients(contraction)
% MCKIBBEN_COEFFICIENTS  What the functions of this folder need: c, dc/de and the integral of c at contractions.
% @{facts}
muscle = struct('length', @{length}, 'supply', @{supply}, 'low', @{low}, 'high', @{high}, 'v', @{m_v});
a = @{m_a};
b = @{m_b};
inside = min(max(contraction, muscle.low), muscle.high);
beyond = contraction - inside;
s = max(-inside, 0);
c = cell(1, 3); slope = c; integral = c;
for i = 1:3
    ci = zeros(size(inside)); si = ci; ii = ci;
    for j = 6:-1:1
        si = si .* inside + ci;
        ci = ci .* inside + a(i, j);
        ii = ii .* inside + a(i, j) / j;
    end
    ci = ci + s .^ 2 .* (b(i, 1) + b(i, 2) * s);
    si = si - s .* (2 * b(i, 1) + 3 * b(i, 2) * s);
    ii = ii .* inside - s .^ 3 .* (b(i, 1) / 3 + b(i, 2) * s / 4);
    integral{i} = ii + beyond .* (ci + 0.5 * si .* beyond);
    c{i} = ci + si .* beyond;
    slope{i} = si;
end
end
