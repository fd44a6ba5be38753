/* forficula, MIT; with three.js and uPlot, MIT: see LICENSES.txt; sources 4f85a115b04de92173328a5334cddf5b5ebf10893fe33934efcb35b0f7e86e06 */
(()=>{function v(n,e={},...t){let i=document.createElement(n);for(let[s,r]of Object.entries(e))s.includes("-")||s==="role"?i.setAttribute(s,r):i[s]=r;return i.append(...t),i}function fs(n,e,t){let i=v("button",{type:"button",title:e,"aria-label":e},n);return i.addEventListener("click",t),i}var Tl=n=>qh(n,24);function qh(n,e){let t="http://www.w3.org/2000/svg",i=document.createElementNS(t,"svg");i.setAttribute("viewBox",`0 0 ${e} ${e}`),e!==24&&i.setAttribute("preserveAspectRatio","none"),i.setAttribute("aria-hidden","true");let s=document.createElementNS(t,"path");return s.setAttribute("d",n),i.append(s),i}function vr({colour:n,dash:e,area:t}){let i="http://www.w3.org/2000/svg",s=document.createElementNS(i,"svg");s.setAttribute("viewBox","0 0 24 8"),s.setAttribute("aria-hidden","true"),s.classList.add("sample");let r=document.createElementNS(i,"path");return r.setAttribute("d",t?"M0 0H24V8H0Z":"M0 4H24"),t&&(r.style.fill=n),r.setAttribute("stroke",t?"none":n),r.setAttribute("stroke-dasharray",e.join(" ")),s.append(r),s}var ym=3,Nb=1e4;function ps(n,e){let t=URL.createObjectURL(n);v("a",{href:t,download:e}).click(),setTimeout(()=>URL.revokeObjectURL(t),Nb)}function qn(n){return`${document.title.split(/: | with /)[0]} ${n}`.toLowerCase().normalize("NFKD").replace(/[^a-z0-9.]+/g,"-").replace(/^-+|-+$/g,"")||"plot"}function Cl(n,e,t){let i=v("button",{type:"button","aria-label":`download ${n} of ${e}`,title:`download as ${n}`},n);return i.addEventListener("click",t),i}function ji(n,e,t){let i=()=>ps(new Blob([t().svg],{type:"image/svg+xml"}),`${e()}.svg`);return v("span",{className:"saves"},Cl("PNG",n,async()=>ps(await Db(t()),`${e()}.png`)),Cl("SVG",n,i))}async function Db({svg:n,width:e,height:t}){let i=URL.createObjectURL(new Blob([n],{type:"image/svg+xml"}));try{let s=v("img",{width:e,height:t});await new Promise((o,a)=>{s.onload=o,s.onerror=a,s.src=i});let r=v("canvas",{width:ym*e,height:ym*t});return r.getContext("2d").drawImage(s,0,0,r.width,r.height),await new Promise(o=>r.toBlob(o,"image/png"))}finally{URL.revokeObjectURL(i)}}function vm(){for(let n of document.querySelectorAll("figure.drawn")){let[e,t]=[n.querySelector("img"),n.querySelector("source")],i=n.closest("section")?.id??"figure",s=[["PNG",e.src],["SVG",t.srcset]].map(([r,o])=>Cl(r,`the figure ${i}`,()=>ps(kb(o),`${qn(i)}.${r.toLowerCase()}`)));n.append(v("div",{className:"saves save-foot"},...s))}}function kb(n){let[e,t]=n.split(","),i=atob(t);return new Blob([Uint8Array.from(i,s=>s.charCodeAt(0))],{type:/:(.*?);/.exec(e)[1]})}function Nt(n){return`${n[0]?.toUpperCase()??""}${n.slice(1)}`}function kn(n,e){let t=n.toFixed(e);return(Number(t)===0?0 .toFixed(e):t).replace("-","−")}function Yh(n,e){return n.replace(/\{(\w+)\}/g,(t,i)=>e[i])}function Mt(n){let e=Number(n.toPrecision(4)),t=Math.abs(e);return(t!==0&&(t>=1e5||t<.001)?n.toExponential(2):String(e)).replaceAll("-","−")}var Zh={};function bm(n){Zh=n}function Sm(n,e){let t=Zh[n],[i,s]=t.find(([,,r])=>e>=r||e===0)??t.at(-1);return{unit:i,factor:s}}function wm(n){return Object.values(Zh).flat().find(([e])=>e===n)[1]}function Gs(n,e){let{unit:t,factor:i}=Sm(e,Math.abs(n));return`${Mt(i*n)} ${t}`}function ua(n){return n.unit?{unit:n.unit,factor:1}:Sm("s",Math.max(Math.abs(n.start),Math.abs(n.end)))}function Ki(n,e){let{unit:t,factor:i}=ua(e),s=Math.ceil(2.7-Math.log10(i*(e.end-e.start)));return`${kn(i*n,Math.min(6,Math.max(0,s)))} ${t}`}var er={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},tr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},ng=0,Ad=1,ig=2;var Ga=1,sg=2,Co=3,nr=0,jn=1,zn=2,Cr=0,Ro=1,Ed=2,Td=3,Cd=4,rg=5;var Rr=100,og=101,ag=102,lg=103,cg=104,ug=200,hg=201,dg=202,fg=203,Rd=204,Pd=205,pg=206,mg=207,gg=208,xg=209,_g=210,yg=211,vg=212,bg=213,Sg=214,ec=0,tc=1,nc=2,xo=3,ic=4,sc=5,rc=6,oc=7,Lc=0,wg=1,Mg=2,is=0,Id=1,Ld=2,Nd=3,Dd=4,kd=5,Od=6,Ud=7;var Fd=300,Pr=301,Po=302,Nc=303,Dc=304,ac=1e3,es=1001,lc=1002,Nn=1003,Ag=1004;var Ha=1005;var Zn=1006,kc=1007;var Cs=1008;var ti=1009,Bd=1010,zd=1011,Io=1012,Oc=1013,ki=1014,Mi=1015,Oi=1016,Uc=1017,Fc=1018,Ir=1020,Vd=35902,Gd=35899,Hd=1021,Wd=1022,Ui=1023,bs=1026,Rs=1027,Bc=1028,zc=1029,ir=1030,Vc=1031;var Gc=1033,Wa=33776,$a=33777,Xa=33778,qa=33779,Hc=35840,Wc=35841,$c=35842,Xc=35843,qc=36196,Yc=37492,Zc=37496,jc=37488,Kc=37489,Ya=37490,Jc=37491,Qc=37808,eu=37809,tu=37810,nu=37811,iu=37812,su=37813,ru=37814,ou=37815,au=37816,lu=37817,cu=37818,uu=37819,hu=37820,du=37821,fu=36492,pu=36494,mu=36495,gu=36283,xu=36284,Za=36285,_u=36286;var ba=2300,cc=2301,Jl=2302,xd=2303,_d=2400,yd=2401,vd=2402;var Eg=3200;var yu=0,Tg=1,Ps="",ci="srgb",Sa="srgb-linear",wa="linear",Dt="srgb";var Ql=7680,$d=7681;var Xd=517;var Cg=519,Rg=512,Pg=513,Ig=514,qd=515,Lg=516,Ng=517,Yd=518,Zd=519,Dg=35044,ja=35048;var jd="300 es",Si=2e3,_o=2001;function Ob(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function Ub(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Ma(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function kg(){let n=Ma("canvas");return n.style.display="block",n}var Mm={},yo=null;function Kd(...n){let e="THREE."+n.shift();yo?yo("log",e,...n):console.log(e,...n)}function Og(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ke(...n){n=Og(n);let e="THREE."+n.shift();if(yo)yo("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function st(...n){n=Og(n);let e="THREE."+n.shift();if(yo)yo("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function _a(...n){let e=n.join(" ");e in Mm||(Mm[e]=!0,Ke(...n))}function Ug(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var Fg={[ec]:ec,[nc]:rc,[ic]:ic,[xo]:sc,[tc]:tc,[rc]:nc,[oc]:oc,[sc]:xo},Di=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Fn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Am=1234567,ya=Math.PI/180,vo=180/Math.PI;function Lo(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Fn[n&255]+Fn[n>>8&255]+Fn[n>>16&255]+Fn[n>>24&255]+"-"+Fn[e&255]+Fn[e>>8&255]+"-"+Fn[e>>16&15|64]+Fn[e>>24&255]+"-"+Fn[t&63|128]+Fn[t>>8&255]+"-"+Fn[t>>16&255]+Fn[t>>24&255]+Fn[i&255]+Fn[i>>8&255]+Fn[i>>16&255]+Fn[i>>24&255]).toLowerCase()}function xt(n,e,t){return Math.max(e,Math.min(t,n))}function Jd(n,e){return(n%e+e)%e}function Fb(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function Bb(n,e,t){return n!==e?(t-n)/(e-n):0}function va(n,e,t){return(1-t)*n+t*e}function zb(n,e,t,i){return va(n,e,1-Math.exp(-t*i))}function Vb(n,e=1){return e-Math.abs(Jd(n,e*2)-e)}function Gb(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function Hb(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function Wb(n,e){return n+Math.floor(Math.random()*(e-n+1))}function $b(n,e){return n+Math.random()*(e-n)}function Xb(n){return n*(.5-Math.random())}function qb(n){n!==void 0&&(Am=n);let e=Am+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function Yb(n){return n*ya}function Zb(n){return n*vo}function jb(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function Kb(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Qd(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Jb(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),h=o((e+i)/2),u=r((e-i)/2),d=o((e-i)/2),f=r((i-e)/2),p=o((i-e)/2);switch(s){case"XYX":n.set(a*h,l*u,l*d,a*c);break;case"YZY":n.set(l*d,a*h,l*u,a*c);break;case"ZXZ":n.set(l*u,l*d,a*h,a*c);break;case"XZX":n.set(a*h,l*p,l*f,a*c);break;case"YXY":n.set(l*f,a*h,l*p,a*c);break;case"ZYZ":n.set(l*p,l*f,a*h,a*c);break;default:Ke("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function ef(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Bg(n,e){if(e.constructor===Float32Array)return n;let t=ef(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function zg(n,e){if(e.constructor===Float32Array)return n;let t=ef(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var tf={DEG2RAD:ya,RAD2DEG:vo,generateUUID:Lo,clamp:xt,euclideanModulo:Jd,mapLinear:Fb,inverseLerp:Bb,lerp:va,damp:zb,pingpong:Vb,smoothstep:Gb,smootherstep:Hb,randInt:Wb,randFloat:$b,randFloatSpread:Xb,seededRandom:qb,degToRad:Yb,radToDeg:Zb,isPowerOfTwo:jb,ceilPowerOfTwo:Kb,floorPowerOfTwo:Qd,setQuaternionFromProperEuler:Jb,normalize:zg,denormalize:Bg},Je=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(xt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},hi=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],h=i[s+2],u=i[s+3],d=r[o+0],f=r[o+1],p=r[o+2],x=r[o+3];if(u!==x||l!==d||c!==f||h!==p){let m=l*d+c*f+h*p+u*x;m<0&&(d=-d,f=-f,p=-p,x=-x,m=-m);let g=1-a;if(m<.9995){let _=Math.acos(m),w=Math.sin(_);g=Math.sin(g*_)/w,a=Math.sin(a*_)/w,l=l*g+d*a,c=c*g+f*a,h=h*g+p*a,u=u*g+x*a}else{l=l*g+d*a,c=c*g+f*a,h=h*g+p*a,u=u*g+x*a;let _=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=_,c*=_,h*=_,u*=_}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],h=i[s+3],u=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return e[t]=a*p+h*u+l*f-c*d,e[t+1]=l*p+h*d+c*u-a*f,e[t+2]=c*p+h*f+a*d-l*u,e[t+3]=h*p-a*u-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),h=a(s/2),u=a(r/2),d=l(i/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"YXZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"ZXY":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"ZYX":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"YZX":this._x=d*h*u+c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u-d*f*p;break;case"XZY":this._x=d*h*u-c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u+d*f*p;break;default:Ke("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],u=t[10],d=i+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>u){let f=2*Math.sqrt(1+i-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-i-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(xt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=i*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-i*c,this._z=r*h+o*c+i*l-s*a,this._w=o*h-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},G=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Em.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Em.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),h=2*(a*t-r*s),u=2*(r*i-o*t);return this.x=t+l*c+o*u-a*h,this.y=i+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this.z=xt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this.z=xt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return jh.copy(this).projectOnVector(e),this.sub(jh)}reflect(e){return this.sub(jh.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(xt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},jh=new G,Em=new hi,rt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=i,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],h=i[4],u=i[7],d=i[2],f=i[5],p=i[8],x=s[0],m=s[3],g=s[6],_=s[1],w=s[4],S=s[7],A=s[2],M=s[5],y=s[8];return r[0]=o*x+a*_+l*A,r[3]=o*m+a*w+l*M,r[6]=o*g+a*S+l*y,r[1]=c*x+h*_+u*A,r[4]=c*m+h*w+u*M,r[7]=c*g+h*S+u*y,r[2]=d*x+f*_+p*A,r[5]=d*m+f*w+p*M,r[8]=d*g+f*S+p*y,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-i*r*h+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,p=t*u+i*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/p;return e[0]=u*x,e[1]=(s*c-h*i)*x,e[2]=(a*i-s*o)*x,e[3]=d*x,e[4]=(h*t-s*l)*x,e[5]=(s*r-a*t)*x,e[6]=f*x,e[7]=(i*l-c*t)*x,e[8]=(o*t-i*r)*x,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return _a("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Kh.makeScale(e,t)),this}rotate(e){return _a("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Kh.makeRotation(-e)),this}translate(e,t){return _a("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Kh.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Kh=new rt,Tm=new rt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Cm=new rt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Qb(){let n={enabled:!0,workingColorSpace:Sa,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Dt&&(s.r=vs(s.r),s.g=vs(s.g),s.b=vs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Dt&&(s.r=go(s.r),s.g=go(s.g),s.b=go(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ps?wa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Sa]:{primaries:e,whitePoint:i,transfer:wa,toXYZ:Tm,fromXYZ:Cm,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:ci},outputColorSpaceConfig:{drawingBufferColorSpace:ci}},[ci]:{primaries:e,whitePoint:i,transfer:Dt,toXYZ:Tm,fromXYZ:Cm,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:ci}}}),n}var St=Qb();function vs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function go(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var to,uc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{to===void 0&&(to=Ma("canvas")),to.width=e.width,to.height=e.height;let s=to.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=to}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Ma("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=vs(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(vs(t[i]/255)*255):t[i]=vs(t[i]);return{data:t,width:e.width,height:e.height}}else return Ke("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},eS=0,bo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:eS++}),this.uuid=Lo(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Jh(s[o].image)):r.push(Jh(s[o]))}else r=Jh(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function Jh(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?uc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ke("Texture: Unable to serialize Texture."),{})}var tS=0,Qh=new G,ei=class n extends Di{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=es,s=es,r=Zn,o=Cs,a=Ui,l=ti,c=n.DEFAULT_ANISOTROPY,h=Ps){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:tS++}),this.uuid=Lo(),this.name="",this.source=new bo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Je(0,0),this.repeat=new Je(1,1),this.center=new Je(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new rt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Qh).x}get height(){return this.source.getSize(Qh).y}get depth(){return this.source.getSize(Qh).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Ke(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ke(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Fd)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case ac:e.x=e.x-Math.floor(e.x);break;case es:e.x=e.x<0?0:1;break;case lc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case ac:e.y=e.y-Math.floor(e.y);break;case es:e.y=e.y<0?0:1;break;case lc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ei.DEFAULT_IMAGE=null;ei.DEFAULT_MAPPING=Fd;ei.DEFAULT_ANISOTROPY=1;var Gt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],p=l[9],x=l[2],m=l[6],g=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-x)<.01&&Math.abs(p-m)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+x)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let w=(c+1)/2,S=(f+1)/2,A=(g+1)/2,M=(h+d)/4,y=(u+x)/4,b=(p+m)/4;return w>S&&w>A?w<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(w),s=M/i,r=y/i):S>A?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=M/s,r=b/s):A<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(A),i=y/r,s=b/r),this.set(i,s,r,t),this}let _=Math.sqrt((m-p)*(m-p)+(u-x)*(u-x)+(d-h)*(d-h));return Math.abs(_)<.001&&(_=1),this.x=(m-p)/_,this.y=(u-x)/_,this.z=(d-h)/_,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this.z=xt(this.z,e.z,t.z),this.w=xt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this.z=xt(this.z,e,t),this.w=xt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},hc=class extends Di{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Zn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Gt(0,0,e,t),this.scissorTest=!1,this.viewport=new Gt(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new ei({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Zn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new bo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},di=class extends hc{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Aa=class extends ei{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Nn,this.minFilter=Nn,this.wrapR=es,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var dc=class extends ei{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Nn,this.minFilter=Nn,this.wrapR=es,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var dt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,h,u,d,f,p,x,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,h,u,d,f,p,x,m)}set(e,t,i,s,r,o,a,l,c,h,u,d,f,p,x,m){let g=this.elements;return g[0]=e,g[4]=t,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=h,g[10]=u,g[14]=d,g[3]=f,g[7]=p,g[11]=x,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/no.setFromMatrixColumn(e,0).length(),r=1/no.setFromMatrixColumn(e,1).length(),o=1/no.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let d=o*h,f=o*u,p=a*h,x=a*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=f+p*c,t[5]=d-x*c,t[9]=-a*l,t[2]=x-d*c,t[6]=p+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*h,f=l*u,p=c*h,x=c*u;t[0]=d+x*a,t[4]=p*a-f,t[8]=o*c,t[1]=o*u,t[5]=o*h,t[9]=-a,t[2]=f*a-p,t[6]=x+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*h,f=l*u,p=c*h,x=c*u;t[0]=d-x*a,t[4]=-o*u,t[8]=p+f*a,t[1]=f+p*a,t[5]=o*h,t[9]=x-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*h,f=o*u,p=a*h,x=a*u;t[0]=l*h,t[4]=p*c-f,t[8]=d*c+x,t[1]=l*u,t[5]=x*c+d,t[9]=f*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,p=a*l,x=a*c;t[0]=l*h,t[4]=x-d*u,t[8]=p*u+f,t[1]=u,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=f*u+p,t[10]=d-x*u}else if(e.order==="XZY"){let d=o*l,f=o*c,p=a*l,x=a*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=d*u+x,t[5]=o*h,t[9]=f*u-p,t[2]=p*u-f,t[6]=a*h,t[10]=x*u+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(nS,e,iS)}lookAt(e,t,i){let s=this.elements;return ai.subVectors(e,t),ai.lengthSq()===0&&(ai.z=1),ai.normalize(),Hs.crossVectors(i,ai),Hs.lengthSq()===0&&(Math.abs(i.z)===1?ai.x+=1e-4:ai.z+=1e-4,ai.normalize(),Hs.crossVectors(i,ai)),Hs.normalize(),Rl.crossVectors(ai,Hs),s[0]=Hs.x,s[4]=Rl.x,s[8]=ai.x,s[1]=Hs.y,s[5]=Rl.y,s[9]=ai.y,s[2]=Hs.z,s[6]=Rl.z,s[10]=ai.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],h=i[1],u=i[5],d=i[9],f=i[13],p=i[2],x=i[6],m=i[10],g=i[14],_=i[3],w=i[7],S=i[11],A=i[15],M=s[0],y=s[4],b=s[8],T=s[12],P=s[1],C=s[5],D=s[9],U=s[13],N=s[2],z=s[6],W=s[10],H=s[14],se=s[3],Y=s[7],J=s[11],te=s[15];return r[0]=o*M+a*P+l*N+c*se,r[4]=o*y+a*C+l*z+c*Y,r[8]=o*b+a*D+l*W+c*J,r[12]=o*T+a*U+l*H+c*te,r[1]=h*M+u*P+d*N+f*se,r[5]=h*y+u*C+d*z+f*Y,r[9]=h*b+u*D+d*W+f*J,r[13]=h*T+u*U+d*H+f*te,r[2]=p*M+x*P+m*N+g*se,r[6]=p*y+x*C+m*z+g*Y,r[10]=p*b+x*D+m*W+g*J,r[14]=p*T+x*U+m*H+g*te,r[3]=_*M+w*P+S*N+A*se,r[7]=_*y+w*C+S*z+A*Y,r[11]=_*b+w*D+S*W+A*J,r[15]=_*T+w*U+S*H+A*te,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],u=e[6],d=e[10],f=e[14],p=e[3],x=e[7],m=e[11],g=e[15],_=l*f-c*d,w=a*f-c*u,S=a*d-l*u,A=o*f-c*h,M=o*d-l*h,y=o*u-a*h;return t*(x*_-m*w+g*S)-i*(p*_-m*A+g*M)+s*(p*w-x*A+g*y)-r*(p*S-x*M+m*y)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-i*(r*h-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=e[9],d=e[10],f=e[11],p=e[12],x=e[13],m=e[14],g=e[15],_=t*a-i*o,w=t*l-s*o,S=t*c-r*o,A=i*l-s*a,M=i*c-r*a,y=s*c-r*l,b=h*x-u*p,T=h*m-d*p,P=h*g-f*p,C=u*m-d*x,D=u*g-f*x,U=d*g-f*m,N=_*U-w*D+S*C+A*P-M*T+y*b;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let z=1/N;return e[0]=(a*U-l*D+c*C)*z,e[1]=(s*D-i*U-r*C)*z,e[2]=(x*y-m*M+g*A)*z,e[3]=(d*M-u*y-f*A)*z,e[4]=(l*P-o*U-c*T)*z,e[5]=(t*U-s*P+r*T)*z,e[6]=(m*S-p*y-g*w)*z,e[7]=(h*y-d*S+f*w)*z,e[8]=(o*D-a*P+c*b)*z,e[9]=(i*P-t*D-r*b)*z,e[10]=(p*M-x*S+g*_)*z,e[11]=(u*S-h*M-f*_)*z,e[12]=(a*T-o*C-l*b)*z,e[13]=(t*C-i*T+s*b)*z,e[14]=(x*w-p*A-m*_)*z,e[15]=(h*A-u*w+d*_)*z,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+i,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,p=r*u,x=o*h,m=o*u,g=a*u,_=l*c,w=l*h,S=l*u,A=i.x,M=i.y,y=i.z;return s[0]=(1-(x+g))*A,s[1]=(f+S)*A,s[2]=(p-w)*A,s[3]=0,s[4]=(f-S)*M,s[5]=(1-(d+g))*M,s[6]=(m+_)*M,s[7]=0,s[8]=(p+w)*y,s[9]=(m-_)*y,s[10]=(1-(d+x))*y,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=no.set(s[0],s[1],s[2]).length(),a=no.set(s[4],s[5],s[6]).length(),l=no.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ii.copy(this);let c=1/o,h=1/a,u=1/l;return Ii.elements[0]*=c,Ii.elements[1]*=c,Ii.elements[2]*=c,Ii.elements[4]*=h,Ii.elements[5]*=h,Ii.elements[6]*=h,Ii.elements[8]*=u,Ii.elements[9]*=u,Ii.elements[10]*=u,t.setFromRotationMatrix(Ii),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Si,l=!1){let c=this.elements,h=2*r/(t-e),u=2*r/(i-s),d=(t+e)/(t-e),f=(i+s)/(i-s),p,x;if(l)p=r/(o-r),x=o*r/(o-r);else if(a===Si)p=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===_o)p=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Si,l=!1){let c=this.elements,h=2/(t-e),u=2/(i-s),d=-(t+e)/(t-e),f=-(i+s)/(i-s),p,x;if(l)p=1/(o-r),x=o/(o-r);else if(a===Si)p=-2/(o-r),x=-(o+r)/(o-r);else if(a===_o)p=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},no=new G,Ii=new dt,nS=new G(0,0,0),iS=new G(1,1,1),Hs=new G,Rl=new G,ai=new G,Rm=new dt,Pm=new hi,Ss=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(xt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-xt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(xt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-xt(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(xt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-xt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Ke("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return Rm.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Rm,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Pm.setFromEuler(this),this.setFromQuaternion(Pm,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ss.DEFAULT_ORDER="XYZ";var So=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},sS=0,Im=new G,io=new hi,ms=new dt,Pl=new G,ha=new G,rS=new G,oS=new hi,Lm=new G(1,0,0),Nm=new G(0,1,0),Dm=new G(0,0,1),km={type:"added"},aS={type:"removed"},so={type:"childadded",child:null},ed={type:"childremoved",child:null},On=class n extends Di{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:sS++}),this.uuid=Lo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new G,t=new Ss,i=new hi,s=new G(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new dt},normalMatrix:{value:new rt}}),this.matrix=new dt,this.matrixWorld=new dt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new So,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return io.setFromAxisAngle(e,t),this.quaternion.multiply(io),this}rotateOnWorldAxis(e,t){return io.setFromAxisAngle(e,t),this.quaternion.premultiply(io),this}rotateX(e){return this.rotateOnAxis(Lm,e)}rotateY(e){return this.rotateOnAxis(Nm,e)}rotateZ(e){return this.rotateOnAxis(Dm,e)}translateOnAxis(e,t){return Im.copy(e).applyQuaternion(this.quaternion),this.position.add(Im.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Lm,e)}translateY(e){return this.translateOnAxis(Nm,e)}translateZ(e){return this.translateOnAxis(Dm,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ms.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Pl.copy(e):Pl.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),ha.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ms.lookAt(ha,Pl,this.up):ms.lookAt(Pl,ha,this.up),this.quaternion.setFromRotationMatrix(ms),s&&(ms.extractRotation(s.matrixWorld),io.setFromRotationMatrix(ms),this.quaternion.premultiply(io.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(st("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(km),so.child=e,this.dispatchEvent(so),so.child=null):st("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(aS),ed.child=e,this.dispatchEvent(ed),ed.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ms.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ms.multiply(e.parent.matrixWorld)),e.applyMatrix4(ms),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(km),so.child=e,this.dispatchEvent(so),so.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ha,e,rS),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ha,oS,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),u=o(e.shapes),d=o(e.skeletons),f=o(e.animations),p=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),u.length>0&&(i.shapes=u),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};On.DEFAULT_UP=new G(0,1,0);On.DEFAULT_MATRIX_AUTO_UPDATE=!0;On.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ln=class extends On{constructor(){super(),this.isGroup=!0,this.type="Group"}},lS={type:"move"},wo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ln,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ln,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new G,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new G),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ln,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new G,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new G,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let x of e.hand.values()){let m=t.getJointPose(x,i),g=this._getHandJoint(c,x);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(lS)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Ln;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},Vg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ws={h:0,s:0,l:0},Il={h:0,s:0,l:0};function td(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var je=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=ci){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,St.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=St.workingColorSpace){return this.r=e,this.g=t,this.b=i,St.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=St.workingColorSpace){if(e=Jd(e,1),t=xt(t,0,1),i=xt(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=td(o,r,e+1/3),this.g=td(o,r,e),this.b=td(o,r,e-1/3)}return St.colorSpaceToWorking(this,s),this}setStyle(e,t=ci){function i(r){r!==void 0&&parseFloat(r)<1&&Ke("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ke("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ke("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=ci){let i=Vg[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ke("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=vs(e.r),this.g=vs(e.g),this.b=vs(e.b),this}copyLinearToSRGB(e){return this.r=go(e.r),this.g=go(e.g),this.b=go(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=ci){return St.workingToColorSpace(Bn.copy(this),e),Math.round(xt(Bn.r*255,0,255))*65536+Math.round(xt(Bn.g*255,0,255))*256+Math.round(xt(Bn.b*255,0,255))}getHexString(e=ci){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=St.workingColorSpace){St.workingToColorSpace(Bn.copy(this),t);let i=Bn.r,s=Bn.g,r=Bn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case i:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-i)/u+2;break;case r:l=(i-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=St.workingColorSpace){return St.workingToColorSpace(Bn.copy(this),t),e.r=Bn.r,e.g=Bn.g,e.b=Bn.b,e}getStyle(e=ci){St.workingToColorSpace(Bn.copy(this),e);let t=Bn.r,i=Bn.g,s=Bn.b;return e!==ci?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Ws),this.setHSL(Ws.h+e,Ws.s+t,Ws.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Ws),e.getHSL(Il);let i=va(Ws.h,Il.h,t),s=va(Ws.s,Il.s,t),r=va(Ws.l,Il.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Bn=new je;je.NAMES=Vg;var Ea=class extends On{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ss,this.environmentIntensity=1,this.environmentRotation=new Ss,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Li=new G,gs=new G,nd=new G,xs=new G,ro=new G,oo=new G,Om=new G,id=new G,sd=new G,rd=new G,od=new Gt,ad=new Gt,ld=new Gt,Qi=class n{constructor(e=new G,t=new G,i=new G){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Li.subVectors(e,t),s.cross(Li);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Li.subVectors(s,t),gs.subVectors(i,t),nd.subVectors(e,t);let o=Li.dot(Li),a=Li.dot(gs),l=Li.dot(nd),c=gs.dot(gs),h=gs.dot(nd),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,p=(o*h-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,xs)===null?!1:xs.x>=0&&xs.y>=0&&xs.x+xs.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,xs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,xs.x),l.addScaledVector(o,xs.y),l.addScaledVector(a,xs.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return od.setScalar(0),ad.setScalar(0),ld.setScalar(0),od.fromBufferAttribute(e,t),ad.fromBufferAttribute(e,i),ld.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(od,r.x),o.addScaledVector(ad,r.y),o.addScaledVector(ld,r.z),o}static isFrontFacing(e,t,i,s){return Li.subVectors(i,t),gs.subVectors(e,t),Li.cross(gs).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Li.subVectors(this.c,this.b),gs.subVectors(this.a,this.b),Li.cross(gs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;ro.subVectors(s,i),oo.subVectors(r,i),id.subVectors(e,i);let l=ro.dot(id),c=oo.dot(id);if(l<=0&&c<=0)return t.copy(i);sd.subVectors(e,s);let h=ro.dot(sd),u=oo.dot(sd);if(h>=0&&u<=h)return t.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(i).addScaledVector(ro,o);rd.subVectors(e,r);let f=ro.dot(rd),p=oo.dot(rd);if(p>=0&&f<=p)return t.copy(r);let x=f*c-l*p;if(x<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(i).addScaledVector(oo,a);let m=h*p-f*u;if(m<=0&&u-h>=0&&f-p>=0)return Om.subVectors(r,s),a=(u-h)/(u-h+(f-p)),t.copy(s).addScaledVector(Om,a);let g=1/(m+x+d);return o=x*g,a=d*g,t.copy(i).addScaledVector(ro,o).addScaledVector(oo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},ts=class{constructor(e=new G(1/0,1/0,1/0),t=new G(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Ni.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Ni.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Ni.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Ni):Ni.fromBufferAttribute(r,o),Ni.applyMatrix4(e.matrixWorld),this.expandByPoint(Ni);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Ll.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Ll.copy(i.boundingBox)),Ll.applyMatrix4(e.matrixWorld),this.union(Ll)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Ni),Ni.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(da),Nl.subVectors(this.max,da),ao.subVectors(e.a,da),lo.subVectors(e.b,da),co.subVectors(e.c,da),$s.subVectors(lo,ao),Xs.subVectors(co,lo),br.subVectors(ao,co);let t=[0,-$s.z,$s.y,0,-Xs.z,Xs.y,0,-br.z,br.y,$s.z,0,-$s.x,Xs.z,0,-Xs.x,br.z,0,-br.x,-$s.y,$s.x,0,-Xs.y,Xs.x,0,-br.y,br.x,0];return!cd(t,ao,lo,co,Nl)||(t=[1,0,0,0,1,0,0,0,1],!cd(t,ao,lo,co,Nl))?!1:(Dl.crossVectors($s,Xs),t=[Dl.x,Dl.y,Dl.z],cd(t,ao,lo,co,Nl))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ni).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Ni).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(_s[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),_s[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),_s[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),_s[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),_s[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),_s[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),_s[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),_s[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(_s),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},_s=[new G,new G,new G,new G,new G,new G,new G,new G],Ni=new G,Ll=new ts,ao=new G,lo=new G,co=new G,$s=new G,Xs=new G,br=new G,da=new G,Nl=new G,Dl=new G,Sr=new G;function cd(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Sr.fromArray(n,r);let a=s.x*Math.abs(Sr.x)+s.y*Math.abs(Sr.y)+s.z*Math.abs(Sr.z),l=e.dot(Sr),c=t.dot(Sr),h=i.dot(Sr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var xn=new G,kl=new Je,cS=0,un=class extends Di{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:cS++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=Dg,this.updateRanges=[],this.gpuType=Mi,this.version=0,this._normalizationScale=e!==void 0?ef(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)kl.fromBufferAttribute(this,t),kl.applyMatrix3(e),this.setXY(t,kl.x,kl.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)xn.fromBufferAttribute(this,t),xn.applyMatrix3(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)xn.fromBufferAttribute(this,t),xn.applyMatrix4(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)xn.fromBufferAttribute(this,t),xn.applyNormalMatrix(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)xn.fromBufferAttribute(this,t),xn.transformDirection(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Bg(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):zg(e,this.array)}};var Ta=class extends un{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Ca=class extends un{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var an=class extends un{constructor(e,t,i){super(new Float32Array(e),t,i)}},uS=new ts,fa=new G,ud=new G,ws=class{constructor(e=new G,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):uS.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;fa.subVectors(e,this.center);let t=fa.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(fa,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(ud.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(fa.copy(e.center).add(ud)),this.expandByPoint(fa.copy(e.center).sub(ud))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},hS=0,bi=new dt,hd=new On,uo=new G,li=new ts,pa=new ts,In=new G,bn=class n extends Di{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:hS++}),this.uuid=Lo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Ob(e)?Ca:Ta)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new rt().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return bi.makeRotationFromQuaternion(e),this.applyMatrix4(bi),this}rotateX(e){return bi.makeRotationX(e),this.applyMatrix4(bi),this}rotateY(e){return bi.makeRotationY(e),this.applyMatrix4(bi),this}rotateZ(e){return bi.makeRotationZ(e),this.applyMatrix4(bi),this}translate(e,t,i){return bi.makeTranslation(e,t,i),this.applyMatrix4(bi),this}scale(e,t,i){return bi.makeScale(e,t,i),this.applyMatrix4(bi),this}lookAt(e){return hd.lookAt(e),hd.updateMatrix(),this.applyMatrix4(hd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(uo).negate(),this.translate(uo.x,uo.y,uo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new an(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ke("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ts);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){st("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new G(-1/0,-1/0,-1/0),new G(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];li.setFromBufferAttribute(r),this.morphTargetsRelative?(In.addVectors(this.boundingBox.min,li.min),this.boundingBox.expandByPoint(In),In.addVectors(this.boundingBox.max,li.max),this.boundingBox.expandByPoint(In)):(this.boundingBox.expandByPoint(li.min),this.boundingBox.expandByPoint(li.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&st('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ws);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){st("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new G,1/0);return}if(e){let i=this.boundingSphere.center;if(li.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];pa.setFromBufferAttribute(a),this.morphTargetsRelative?(In.addVectors(li.min,pa.min),li.expandByPoint(In),In.addVectors(li.max,pa.max),li.expandByPoint(In)):(li.expandByPoint(pa.min),li.expandByPoint(pa.max))}li.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)In.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(In));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)In.fromBufferAttribute(a,c),l&&(uo.fromBufferAttribute(e,c),In.add(uo)),s=Math.max(s,i.distanceToSquared(In))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&st('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){st("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new un(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let T=0;T<i.count;T++)a[T]=new G,l[T]=new G;let h=new G,u=new G,d=new G,f=new Je,p=new Je,x=new Je,m=new G,g=new G;function _(T,P,C){c[T]=c[P]=c[C]=1,h.fromBufferAttribute(i,T),u.fromBufferAttribute(i,P),d.fromBufferAttribute(i,C),f.fromBufferAttribute(r,T),p.fromBufferAttribute(r,P),x.fromBufferAttribute(r,C),u.sub(h),d.sub(h),p.sub(f),x.sub(f);let D=1/(p.x*x.y-x.x*p.y);isFinite(D)&&(m.copy(u).multiplyScalar(x.y).addScaledVector(d,-p.y).multiplyScalar(D),g.copy(d).multiplyScalar(p.x).addScaledVector(u,-x.x).multiplyScalar(D),a[T].add(m),a[P].add(m),a[C].add(m),l[T].add(g),l[P].add(g),l[C].add(g))}let w=this.groups;w.length===0&&(w=[{start:0,count:e.count}]);for(let T=0,P=w.length;T<P;++T){let C=w[T],D=C.start,U=C.count;for(let N=D,z=D+U;N<z;N+=3)_(e.getX(N+0),e.getX(N+1),e.getX(N+2))}let S=new G,A=new G,M=new G,y=new G;function b(T){M.fromBufferAttribute(s,T),y.copy(M);let P=a[T];S.copy(P),S.sub(M.multiplyScalar(M.dot(P))).normalize(),A.crossVectors(y,P);let D=A.dot(l[T])<0?-1:1;o.setXYZW(T,S.x,S.y,S.z,D)}for(let T=0,P=i.count;T<P;++T)c[T]&&b(T);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new un(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new G,r=new G,o=new G,a=new G,l=new G,c=new G,h=new G,u=new G;if(e)for(let d=0,f=e.count;d<f;d+=3){let p=e.getX(d+0),x=e.getX(d+1),m=e.getX(d+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,x),o.fromBufferAttribute(t,m),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,m),a.add(h),l.add(h),c.add(h),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),i.setXYZ(d+0,h.x,h.y,h.z),i.setXYZ(d+1,h.x,h.y,h.z),i.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)In.fromBufferAttribute(e,t),In.normalize(),e.setXYZ(t,In.x,In.y,In.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,p=0;for(let x=0,m=l.length;x<m;x++){a.isInterleavedBufferAttribute?f=l[x]*a.data.stride+a.offset:f=l[x]*h;for(let g=0;g<h;g++)d[p++]=c[f++]}return new un(d,h,u)}if(this.index===null)return Ke("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=e(d,i);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var dd=new G,dS=new G,fS=new rt,ui=class{constructor(e=new G(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=dd.subVectors(i,t).cross(dS.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(dd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||fS.getNormalMatrix(e),s=this.coplanarPoint(dd).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},pS=0,Ms=class extends Di{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:pS++}),this.uuid=Lo(),this.name="",this.type="Material",this.blending=Ro,this.side=nr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Rd,this.blendDst=Pd,this.blendEquation=Rr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new je(0,0,0),this.blendAlpha=0,this.depthFunc=xo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Cg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Ql,this.stencilZFail=Ql,this.stencilZPass=Ql,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ke(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ke(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new je().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new ui().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Je().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Je().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var ys=new G,fd=new G,Ol=new G,Ul=new G,Ys=class{constructor(e=new G,t=new G(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ys)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=ys.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ys.copy(this.origin).addScaledVector(this.direction,t),ys.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){fd.copy(e).add(t).multiplyScalar(.5),Ol.copy(t).sub(e).normalize(),Ul.copy(this.origin).sub(fd);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Ol),a=Ul.dot(this.direction),l=-Ul.dot(Ol),c=Ul.lengthSq(),h=Math.abs(1-o*o),u,d,f,p;if(h>0)if(u=o*l-a,d=o*a-l,p=r*h,u>=0)if(d>=-p)if(d<=p){let x=1/h;u*=x,d*=x,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-p?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=p?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(fd).addScaledVector(Ol,d),f}intersectSphere(e,t){if(e.radius<0)return null;ys.subVectors(e.center,this.origin);let i=ys.dot(this.direction),s=ys.dot(ys)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(i=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(i=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),h>=0?(r=(e.min.y-d.y)*h,o=(e.max.y-d.y)*h):(r=(e.max.y-d.y)*h,o=(e.min.y-d.y)*h),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(e.min.z-d.z)*u,l=(e.max.z-d.z)*u):(a=(e.max.z-d.z)*u,l=(e.min.z-d.z)*u),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,ys)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=e.x-o.x,d=e.y-o.y,f=e.z-o.z,p=t.x-o.x,x=t.y-o.y,m=t.z-o.z,g=i.x-o.x,_=i.y-o.y,w=i.z-o.z,S=Math.abs(l),A=Math.abs(c),M=Math.abs(h),y,b,T,P,C,D,U,N,z,W,H,se;if(S>=A&&S>=M?(T=l,D=u,z=p,se=g,l>=0?(y=c,b=h,P=d,C=f,U=x,N=m,W=_,H=w):(y=h,b=c,P=f,C=d,U=m,N=x,W=w,H=_)):A>=M?(T=c,D=d,z=x,se=_,c>=0?(y=h,b=l,P=f,C=u,U=m,N=p,W=w,H=g):(y=l,b=h,P=u,C=f,U=p,N=m,W=g,H=w)):(T=h,D=f,z=m,se=w,h>=0?(y=l,b=c,P=u,C=d,U=p,N=x,W=g,H=_):(y=c,b=l,P=d,C=u,U=x,N=p,W=_,H=g)),T===0)return null;let Y=y/T,J=b/T,te=1/T,pe=P-Y*D,fe=C-J*D,ee=U-Y*z,he=N-J*z,xe=W-Y*se,be=H-J*se,Se=xe*he-be*ee,$e=pe*be-fe*xe,ot=ee*fe-he*pe;if(s){if(Se<0||$e<0||ot<0)return null}else if((Se<0||$e<0||ot<0)&&(Se>0||$e>0||ot>0))return null;let We=Se+$e+ot;if(We===0)return null;let lt=te*(Se*D+$e*z+ot*se);return(We>0?lt<0:lt>0)?null:this.at(lt/We,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},As=class extends Ms{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new je(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ss,this.combine=Lc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Um=new dt,wr=new Ys,Fl=new ws,Fm=new G,Bl=new G,zl=new G,Vl=new G,pd=new G,Gl=new G,Bm=new G,Hl=new G,_n=class extends On{constructor(e=new bn,t=new As){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Gl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(pd.fromBufferAttribute(u,e),o?Gl.addScaledVector(pd,h):Gl.addScaledVector(pd.sub(t),h))}t.add(Gl)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Fl.copy(i.boundingSphere),Fl.applyMatrix4(r),wr.copy(e.ray).recast(e.near),!(Fl.containsPoint(wr.origin)===!1&&(wr.intersectSphere(Fl,Fm)===null||wr.origin.distanceToSquared(Fm)>(e.far-e.near)**2))&&(Um.copy(r).invert(),wr.copy(e.ray).applyMatrix4(Um),!(i.boundingBox!==null&&wr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,wr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let m=d[p],g=o[m.materialIndex],_=Math.max(m.start,f.start),w=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let S=_,A=w;S<A;S+=3){let M=a.getX(S),y=a.getX(S+1),b=a.getX(S+2);s=Wl(this,g,e,i,c,h,u,M,y,b),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let _=a.getX(m),w=a.getX(m+1),S=a.getX(m+2);s=Wl(this,o,e,i,c,h,u,_,w,S),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let m=d[p],g=o[m.materialIndex],_=Math.max(m.start,f.start),w=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let S=_,A=w;S<A;S+=3){let M=S,y=S+1,b=S+2;s=Wl(this,g,e,i,c,h,u,M,y,b),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(l.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let _=m,w=m+1,S=m+2;s=Wl(this,o,e,i,c,h,u,_,w,S),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function mS(n,e,t,i,s,r,o,a){let l;if(e.side===jn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===nr,a),l===null)return null;Hl.copy(a),Hl.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Hl);return c<t.near||c>t.far?null:{distance:c,point:Hl.clone(),object:n}}function Wl(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,Bl),n.getVertexPosition(l,zl),n.getVertexPosition(c,Vl);let h=mS(n,e,t,i,Bl,zl,Vl,Bm);if(h){let u=new G;Qi.getBarycoord(Bm,Bl,zl,Vl,u),s&&(h.uv=Qi.getInterpolatedAttribute(s,a,l,c,u,new Je)),r&&(h.uv1=Qi.getInterpolatedAttribute(r,a,l,c,u,new Je)),o&&(h.normal=Qi.getInterpolatedAttribute(o,a,l,c,u,new G),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new G,materialIndex:0};Qi.getNormal(Bl,zl,Vl,d.normal),h.face=d,h.barycoord=u}return h}var Ra=class extends ei{constructor(e=null,t=1,i=1,s,r,o,a,l,c=Nn,h=Nn,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Pa=class extends un{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},ho=new dt,zm=new dt,$l=[],Vm=new ts,gS=new dt,ma=new _n,ga=new ws,fi=class extends _n{constructor(e,t,i){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Pa(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,gS)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new ts),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,ho),Vm.copy(e.boundingBox).applyMatrix4(ho),this.boundingBox.union(Vm)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new ws),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,ho),ga.copy(e.boundingSphere).applyMatrix4(ho),this.boundingSphere.union(ga)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let i=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=e*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(e,t){let i=this.matrixWorld,s=this.count;if(ma.geometry=this.geometry,ma.material=this.material,ma.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),ga.copy(this.boundingSphere),ga.applyMatrix4(i),e.ray.intersectsSphere(ga)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,ho),zm.multiplyMatrices(i,ho),ma.matrixWorld=zm,ma.raycast(e,$l);for(let o=0,a=$l.length;o<a;o++){let l=$l[o];l.instanceId=r,l.object=this,t.push(l)}$l.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Pa(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let i=t.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new Ra(new Float32Array(s*this.count),s,this.count,Bc,Mi));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Mr=new ws,xS=new Je(.5,.5),Xl=new G,Zs=class{constructor(e=new ui,t=new ui,i=new ui,s=new ui,r=new ui,o=new ui){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Si,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],p=r[8],x=r[9],m=r[10],g=r[11],_=r[12],w=r[13],S=r[14],A=r[15];if(s[0].setComponents(c-o,f-h,g-p,A-_).normalize(),s[1].setComponents(c+o,f+h,g+p,A+_).normalize(),s[2].setComponents(c+a,f+u,g+x,A+w).normalize(),s[3].setComponents(c-a,f-u,g-x,A-w).normalize(),i)s[4].setComponents(l,d,m,S).normalize(),s[5].setComponents(c-l,f-d,g-m,A-S).normalize();else if(s[4].setComponents(c-l,f-d,g-m,A-S).normalize(),t===Si)s[5].setComponents(c+l,f+d,g+m,A+S).normalize();else if(t===_o)s[5].setComponents(l,d,m,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Mr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Mr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Mr)}intersectsSprite(e){Mr.center.set(0,0,0);let t=xS.distanceTo(e.center);return Mr.radius=.7071067811865476+t,Mr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Mr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(Xl.x=s.normal.x>0?e.max.x:e.min.x,Xl.y=s.normal.y>0?e.max.y:e.min.y,Xl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Xl)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Gm=new dt,fc=class n{constructor(){this.coordinateSystem=Si,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];Gm.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Zs),i[s].setFromProjectionMatrix(Gm,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Zs),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var js=class extends Ms{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new je(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},pc=new G,mc=new G,Hm=new dt,xa=new Ys,ql=new ws,md=new G,Wm=new G,gc=class extends On{constructor(e=new bn,t=new js){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)pc.fromBufferAttribute(t,s-1),mc.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=pc.distanceTo(mc);e.setAttribute("lineDistance",new an(i,1))}else Ke("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),ql.copy(i.boundingSphere),ql.applyMatrix4(s),ql.radius+=r,e.ray.intersectsSphere(ql)===!1)return;Hm.copy(s).invert(),xa.copy(e.ray).applyMatrix4(Hm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=i.index,d=i.attributes.position;if(h!==null){let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let x=f,m=p-1;x<m;x+=c){let g=h.getX(x),_=h.getX(x+1),w=Yl(this,e,xa,l,g,_,x);w&&t.push(w)}if(this.isLineLoop){let x=h.getX(p-1),m=h.getX(f),g=Yl(this,e,xa,l,x,m,p-1);g&&t.push(g)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let x=f,m=p-1;x<m;x+=c){let g=Yl(this,e,xa,l,x,x+1,x);g&&t.push(g)}if(this.isLineLoop){let x=Yl(this,e,xa,l,p-1,f,p-1);x&&t.push(x)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Yl(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(pc.fromBufferAttribute(a,s),mc.fromBufferAttribute(a,r),t.distanceSqToSegment(pc,mc,md,Wm)>i)return;md.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(md);if(!(c<e.near||c>e.far))return{distance:c,point:Wm.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var $m=new G,Xm=new G,Ar=class extends gc{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)$m.fromBufferAttribute(t,s),Xm.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+$m.distanceTo(Xm);e.setAttribute("lineDistance",new an(i,1))}else Ke("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ia=class extends ei{constructor(e=[],t=Pr,i,s,r,o,a,l,c,h){super(e,t,i,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Es=class extends ei{constructor(e,t,i=ki,s,r,o,a=Nn,l=Nn,c,h=bs,u=1){if(h!==bs&&h!==Rs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:u};super(d,s,r,o,a,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new bo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},La=class extends Es{constructor(e,t=ki,i=Pr,s,r,o=Nn,a=Nn,l,c=bs){let h={width:e,height:e,depth:1},u=[h,h,h,h,h,h];super(e,e,t,i,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Na=class extends ei{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Mo=class n extends bn{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;p("z","y","x",-1,-1,i,t,e,o,r,0),p("z","y","x",1,-1,i,t,-e,o,r,1),p("x","z","y",1,1,e,i,t,s,o,2),p("x","z","y",1,-1,e,i,-t,s,o,3),p("x","y","z",1,-1,e,t,i,s,r,4),p("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new an(c,3)),this.setAttribute("normal",new an(h,3)),this.setAttribute("uv",new an(u,2));function p(x,m,g,_,w,S,A,M,y,b,T){let P=S/y,C=A/b,D=S/2,U=A/2,N=M/2,z=y+1,W=b+1,H=0,se=0,Y=new G;for(let J=0;J<W;J++){let te=J*C-U;for(let pe=0;pe<z;pe++){let fe=pe*P-D;Y[x]=fe*_,Y[m]=te*w,Y[g]=N,c.push(Y.x,Y.y,Y.z),Y[x]=0,Y[m]=0,Y[g]=M>0?1:-1,h.push(Y.x,Y.y,Y.z),u.push(pe/y),u.push(1-J/b),H+=1}}for(let J=0;J<b;J++)for(let te=0;te<y;te++){let pe=d+te+z*J,fe=d+te+z*(J+1),ee=d+(te+1)+z*(J+1),he=d+(te+1)+z*J;l.push(pe,fe,he),l.push(fe,ee,he),se+=6}a.addGroup(f,se,T),f+=se,d+=H}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var wi=class n extends bn{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],d=[],f=[],p=0,x=[],m=i/2,g=0;_(),o===!1&&(e>0&&w(!0),t>0&&w(!1)),this.setIndex(h),this.setAttribute("position",new an(u,3)),this.setAttribute("normal",new an(d,3)),this.setAttribute("uv",new an(f,2));function _(){let S=new G,A=new G,M=0,y=(t-e)/i;for(let b=0;b<=r;b++){let T=[],P=b/r,C=P*(t-e)+e;for(let D=0;D<=s;D++){let U=D/s,N=U*l+a,z=Math.sin(N),W=Math.cos(N);A.x=C*z,A.y=-P*i+m,A.z=C*W,u.push(A.x,A.y,A.z),S.set(z,y,W).normalize(),d.push(S.x,S.y,S.z),f.push(U,1-P),T.push(p++)}x.push(T)}for(let b=0;b<s;b++)for(let T=0;T<r;T++){let P=x[T][b],C=x[T+1][b],D=x[T+1][b+1],U=x[T][b+1];(e>0||T!==0)&&(h.push(P,C,U),M+=3),(t>0||T!==r-1)&&(h.push(C,D,U),M+=3)}c.addGroup(g,M,0),g+=M}function w(S){let A=p,M=new Je,y=new G,b=0,T=S===!0?e:t,P=S===!0?1:-1;for(let D=1;D<=s;D++)u.push(0,m*P,0),d.push(0,P,0),f.push(.5,.5),p++;let C=p;for(let D=0;D<=s;D++){let N=D/s*l+a,z=Math.cos(N),W=Math.sin(N);y.x=T*W,y.y=m*P,y.z=T*z,u.push(y.x,y.y,y.z),d.push(0,P,0),M.x=z*.5+.5,M.y=W*.5*P+.5,f.push(M.x,M.y),p++}for(let D=0;D<s;D++){let U=A+D,N=C+D;S===!0?h.push(N,N+1,U):h.push(N+1,N,U),b+=3}c.addGroup(g,b,S===!0?1:2),g+=b}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Er=class n extends wi{constructor(e=1,t=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new n(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Da=class n extends bn{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,h=l+1,u=e/a,d=t/l,f=[],p=[],x=[],m=[];for(let g=0;g<h;g++){let _=g*d-o;for(let w=0;w<c;w++){let S=w*u-r;p.push(S,-_,0),x.push(0,0,1),m.push(w/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let _=0;_<a;_++){let w=_+c*g,S=_+c*(g+1),A=_+1+c*(g+1),M=_+1+c*g;f.push(w,S,M),f.push(S,A,M)}this.setIndex(f),this.setAttribute("position",new an(p,3)),this.setAttribute("normal",new an(x,3)),this.setAttribute("uv",new an(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var Ao=class n extends bn{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new G,d=new G,f=[],p=[],x=[],m=[];for(let g=0;g<=i;g++){let _=[],w=g/i,S=o+w*a,A=e*Math.cos(S),M=Math.sqrt(e*e-A*A),y=0;g===0&&o===0?y=.5/t:g===i&&l===Math.PI&&(y=-.5/t);for(let b=0;b<=t;b++){let T=b/t,P=s+T*r;u.x=-M*Math.cos(P),u.y=A,u.z=M*Math.sin(P),p.push(u.x,u.y,u.z),d.copy(u).normalize(),x.push(d.x,d.y,d.z),m.push(T+y,1-w),_.push(c++)}h.push(_)}for(let g=0;g<i;g++)for(let _=0;_<t;_++){let w=h[g][_+1],S=h[g][_],A=h[g+1][_],M=h[g+1][_+1];(g!==0||o>0)&&f.push(w,S,M),(g!==i-1||l<Math.PI)&&f.push(S,A,M)}this.setIndex(f),this.setAttribute("position",new an(p,3)),this.setAttribute("normal",new an(x,3)),this.setAttribute("uv",new an(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function Lr(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(qm(s))s.isRenderTargetTexture?(Ke("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(qm(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function Vn(n){let e={};for(let t=0;t<n.length;t++){let i=Lr(n[t]);for(let s in i)e[s]=i[s]}return e}function qm(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function _S(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function nf(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:St.workingColorSpace}var Gg={clone:Lr,merge:Vn},yS=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,vS=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ns=class extends Ms{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=yS,this.fragmentShader=vS,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Lr(e.uniforms),this.uniformsGroups=_S(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new je().setHex(s.value);break;case"v2":this.uniforms[i].value=new Je().fromArray(s.value);break;case"v3":this.uniforms[i].value=new G().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Gt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new rt().fromArray(s.value);break;case"m4":this.uniforms[i].value=new dt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},xc=class extends ns{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Ts=class extends Ms{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new je(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new je(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=yu,this.normalScale=new Je(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ss,this.combine=Lc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},_c=class extends Ms{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Eg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},yc=class extends Ms{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function fo(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function Zl(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Ks=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break e}o=i,i=0;break t}break n}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},vc=class extends Ks{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:_d,endingEnd:_d}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case yd:r=e,a=2*t-i;break;case vd:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case yd:o=e,l=2*i-t;break;case vd:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(i-t)/(s-t),x=p*p,m=x*p,g=-d*m+2*d*x-d*p,_=(1+d)*m+(-1.5-2*d)*x+(-.5+d)*p+1,w=(-1-f)*m+(1.5+f)*x+.5*p,S=f*m-f*x;for(let A=0;A!==a;++A)r[A]=g*o[h+A]+_*o[c+A]+w*o[l+A]+S*o[u+A];return r}},bc=class extends Ks{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(i-t)/(s-t),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},Sc=class extends Ks{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},wc=class extends Ks{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let p=(i-t)/(s-t),x=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*x+o[l+m]*p;return r}let d=a*2,f=e-1;for(let p=0;p!==a;++p){let x=o[c+p],m=o[l+p],g=f*d+p*2,_=u[g],w=u[g+1],S=e*d+p*2,A=h[S],M=h[S+1],y=SS(i,t,_,A,s);r[p]=Hg(y,x,w,M,m)}return r}};function Hg(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function bS(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function SS(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=Hg(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=bS(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var pi=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=fo(t,this.TimeBufferType),this.values=fo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:fo(e.times,Array),values:fo(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),Zl(e.settings)&&(i.settings={inTangents:fo(e.settings.inTangents,Array),outTangents:fo(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Sc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new bc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new vc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new wc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case ba:t=this.InterpolantFactoryMethodDiscrete;break;case cc:t=this.InterpolantFactoryMethodLinear;break;case Jl:t=this.InterpolantFactoryMethodSmooth;break;case xd:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ke("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ba;case this.InterpolantFactoryMethodLinear:return cc;case this.InterpolantFactoryMethodSmooth:return Jl;case this.InterpolantFactoryMethodBezier:return xd}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;Zl(this.settings)&&(Ym(this.settings.inTangents,e),Ym(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;Zl(this.settings)&&(Zm(this.settings.inTangents,e),Zm(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(st("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(st("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){st("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){st("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&Ub(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){st("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Jl,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let u=a*i,d=u-i,f=u+i;for(let p=0;p!==i;++p){let x=t[u+p];if(x!==t[d+p]||x!==t[f+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let u=a*i,d=o*i;for(let f=0;f!==i;++f)t[d+f]=t[u+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,Zl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Ym(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function Zm(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}pi.prototype.ValueTypeName="";pi.prototype.TimeBufferType=Float32Array;pi.prototype.ValueBufferType=Float32Array;pi.prototype.DefaultInterpolation=cc;var Js=class extends pi{constructor(e,t,i){super(e,t,i)}};Js.prototype.ValueTypeName="bool";Js.prototype.ValueBufferType=Array;Js.prototype.DefaultInterpolation=ba;Js.prototype.InterpolantFactoryMethodLinear=void 0;Js.prototype.InterpolantFactoryMethodSmooth=void 0;var Mc=class extends pi{constructor(e,t,i,s){super(e,t,i,s)}};Mc.prototype.ValueTypeName="color";var Ac=class extends pi{constructor(e,t,i,s){super(e,t,i,s)}};Ac.prototype.ValueTypeName="number";var Ec=class extends Ks{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)hi.slerpFlat(r,0,o,c-a,o,c,l);return r}},ka=class extends pi{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new Ec(this.times,this.values,this.getValueSize(),e)}};ka.prototype.ValueTypeName="quaternion";ka.prototype.InterpolantFactoryMethodSmooth=void 0;var Qs=class extends pi{constructor(e,t,i){super(e,t,i)}};Qs.prototype.ValueTypeName="string";Qs.prototype.ValueBufferType=Array;Qs.prototype.DefaultInterpolation=ba;Qs.prototype.InterpolantFactoryMethodLinear=void 0;Qs.prototype.InterpolantFactoryMethodSmooth=void 0;var Tc=class extends pi{constructor(e,t,i,s){super(e,t,i,s)}};Tc.prototype.ValueTypeName="vector";var Cc=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],p=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Wg=new Cc,Rc=class{constructor(e){this.manager=e!==void 0?e:Wg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Rc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Oa=class extends On{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new je(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},Ua=class extends Oa{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(On.DEFAULT_UP),this.updateMatrix(),this.groundColor=new je(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},gd=new dt,jm=new G,Km=new G,Pc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Je(512,512),this.mapType=ti,this.map=null,this.mapPass=null,this.matrix=new dt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Zs,this._frameExtents=new Je(1,1),this._viewportCount=1,this._viewports=[new Gt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;jm.setFromMatrixPosition(e.matrixWorld),t.position.copy(jm),Km.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Km),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){gd.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(gd,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===_o||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(gd)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},jl=new G,Kl=new hi,Ji=new G,Fa=class extends On{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new dt,this.projectionMatrix=new dt,this.projectionMatrixInverse=new dt,this.coordinateSystem=Si,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(jl,Kl,Ji),Ji.x===1&&Ji.y===1&&Ji.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(jl,Kl,Ji.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(jl,Kl,Ji),Ji.x===1&&Ji.y===1&&Ji.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(jl,Kl,Ji.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},qs=new G,Jm=new Je,Qm=new Je,Yn=class extends Fa{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=vo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(ya*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return vo*2*Math.atan(Math.tan(ya*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){qs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(qs.x,qs.y).multiplyScalar(-e/qs.z),qs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(qs.x,qs.y).multiplyScalar(-e/qs.z)}getViewSize(e,t){return this.getViewBounds(e,Jm,Qm),t.subVectors(Qm,Jm)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(ya*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Ba=class extends Fa{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},bd=class extends Pc{constructor(){super(new Ba(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},za=class extends Oa{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(On.DEFAULT_UP),this.updateMatrix(),this.target=new On,this.shadow=new bd}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var po=-90,mo=1,Eo=class extends On{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Yn(po,mo,e,t);s.layers=this.layers,this.add(s);let r=new Yn(po,mo,e,t);r.layers=this.layers,this.add(r);let o=new Yn(po,mo,e,t);o.layers=this.layers,this.add(o);let a=new Yn(po,mo,e,t);a.layers=this.layers,this.add(a);let l=new Yn(po,mo,e,t);l.layers=this.layers,this.add(l);let c=new Yn(po,mo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Si)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===_o)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=x,e.setRenderTarget(i,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(u,d,f),e.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},Ic=class extends Yn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var sf="\\[\\]\\.:\\/",wS=new RegExp("["+sf+"]","g"),rf="[^"+sf+"]",MS="[^"+sf.replace("\\.","")+"]",AS=/((?:WC+[\/:])*)/.source.replace("WC",rf),ES=/(WCOD+)?/.source.replace("WCOD",MS),TS=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",rf),CS=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",rf),RS=new RegExp("^"+AS+ES+TS+CS+"$"),PS=["material","materials","bones","map"],Sd=class{constructor(e,t,i){let s=i||jt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},jt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(wS,"")}static parseTrackName(e){let t=RS.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);PS.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ke("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){st("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){st("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){st("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){st("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){st("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){st("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){st("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;st("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){st("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){st("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};jt.Composite=Sd;jt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};jt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};jt.prototype.GetterByBindingType=[jt.prototype._getValue_direct,jt.prototype._getValue_array,jt.prototype._getValue_arrayElement,jt.prototype._getValue_toArray];jt.prototype.SetterByBindingTypeAndVersioning=[[jt.prototype._setValue_direct,jt.prototype._setValue_direct_setNeedsUpdate,jt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_array,jt.prototype._setValue_array_setNeedsUpdate,jt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_arrayElement,jt.prototype._setValue_arrayElement_setNeedsUpdate,jt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_fromArray,jt.prototype._setValue_fromArray_setNeedsUpdate,jt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var K3=new Float32Array(1);var eg=new dt,Tr=class{constructor(e,t,i=0,s=1/0){this.ray=new Ys(e,t),this.near=i,this.far=s,this.camera=null,this.layers=new So,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):st("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return eg.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(eg),this}intersectObject(e,t=!0,i=[]){return wd(e,this,i,t),i.sort(tg),i}intersectObjects(e,t=!0,i=[]){for(let s=0,r=e.length;s<r;s++)wd(e[s],this,i,t);return i.sort(tg),i}};function tg(n,e){return n.distance-e.distance}function wd(n,e,t,i){let s=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)wd(r[o],e,t,!0)}}var To=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=xt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(xt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Md=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var Va=class extends Di{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function of(n,e,t,i){let s=IS(i);switch(t){case Hd:return n*e;case Bc:return n*e/s.components*s.byteLength;case zc:return n*e/s.components*s.byteLength;case ir:return n*e*2/s.components*s.byteLength;case Vc:return n*e*2/s.components*s.byteLength;case Wd:return n*e*3/s.components*s.byteLength;case Ui:return n*e*4/s.components*s.byteLength;case Gc:return n*e*4/s.components*s.byteLength;case Wa:case $a:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Xa:case qa:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Wc:case Xc:return Math.max(n,16)*Math.max(e,8)/4;case Hc:case $c:return Math.max(n,8)*Math.max(e,8)/2;case qc:case Yc:case jc:case Kc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Zc:case Ya:case Jc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Qc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case eu:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case tu:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case nu:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case iu:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case su:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case ru:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case ou:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case au:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case lu:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case cu:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case uu:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case hu:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case du:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case fu:case pu:case mu:return Math.ceil(n/4)*Math.ceil(e/4)*16;case gu:case xu:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Za:case _u:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function IS(n){switch(n){case ti:case Bd:return{byteLength:1,components:1};case Io:case zd:case Oi:return{byteLength:2,components:1};case Uc:case Fc:return{byteLength:2,components:4};case ki:case Oc:case Mi:return{byteLength:4,components:1};case Vd:case Gd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ke("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function d0(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function NS(n){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function i(a,l,c){let h=l.array,u=l.updateRanges;if(n.bindBuffer(c,a),u.length===0)n.bufferSubData(c,0,h);else{u.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<u.length;f++){let p=u[d],x=u[f];x.start<=p.start+p.count+1?p.count=Math.max(p.count,x.start+x.count-p.start):(++d,u[d]=x)}u.length=d+1;for(let f=0,p=u.length;f<p;f++){let x=u[f];n.bufferSubData(c,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var DS=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,kS=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,OS=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,US=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,FS=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,BS=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,zS=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,VS=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,GS=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,HS=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,WS=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,$S=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,XS=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,qS=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,YS=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,ZS=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,jS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,KS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,JS=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,QS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,ew=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,tw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,nw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,iw=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,sw=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,rw=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,ow=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,aw=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,lw=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,cw="gl_FragColor = linearToOutputTexel( gl_FragColor );",uw=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,hw=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,dw=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,fw=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,pw=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,mw=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,gw=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,xw=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,_w=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,yw=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,vw=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,bw=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Sw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,ww=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Mw=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Aw=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Ew=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Tw=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Cw=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Rw=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Pw=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Iw=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Lw=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Nw=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Dw=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,kw=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Ow=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Uw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Fw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Bw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,zw=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Vw=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Gw=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Hw=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Ww=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,$w=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Xw=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,qw=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Yw=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Zw=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,jw=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Kw=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Jw=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Qw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,eM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,tM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,nM=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,iM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,sM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,rM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,oM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,aM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,lM=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,cM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,uM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,hM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,dM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,fM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,pM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,mM=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,gM=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,xM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,_M=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,yM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,vM=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,bM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,SM=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,wM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,MM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,AM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,EM=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,TM=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,CM=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,RM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,PM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,IM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,LM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,NM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,DM=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,kM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,OM=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,UM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,FM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,BM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,zM=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,VM=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,GM=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,HM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,WM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,$M=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,XM=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,qM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,YM=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ZM=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,jM=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,KM=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,JM=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,QM=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,e1=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,t1=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,n1=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,i1=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,s1=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,r1=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,o1=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,a1=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,l1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,c1=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,u1=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,h1=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,d1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,pt={alphahash_fragment:DS,alphahash_pars_fragment:kS,alphamap_fragment:OS,alphamap_pars_fragment:US,alphatest_fragment:FS,alphatest_pars_fragment:BS,aomap_fragment:zS,aomap_pars_fragment:VS,batching_pars_vertex:GS,batching_vertex:HS,begin_vertex:WS,beginnormal_vertex:$S,bsdfs:XS,iridescence_fragment:qS,bumpmap_pars_fragment:YS,clipping_planes_fragment:ZS,clipping_planes_pars_fragment:jS,clipping_planes_pars_vertex:KS,clipping_planes_vertex:JS,color_fragment:QS,color_pars_fragment:ew,color_pars_vertex:tw,color_vertex:nw,common:iw,defaultnormal_vertex:sw,displacementmap_pars_vertex:rw,displacementmap_vertex:ow,emissivemap_fragment:aw,emissivemap_pars_fragment:lw,colorspace_fragment:cw,colorspace_pars_fragment:uw,envmap_fragment:hw,envmap_common_pars_fragment:dw,envmap_pars_fragment:fw,envmap_pars_vertex:pw,envmap_physical_pars_fragment:Aw,envmap_vertex:mw,fog_vertex:gw,fog_pars_vertex:xw,fog_fragment:_w,fog_pars_fragment:yw,gradientmap_pars_fragment:vw,lightmap_pars_fragment:bw,lights_lambert_fragment:Sw,lights_lambert_pars_fragment:ww,lights_pars_begin:Mw,lights_toon_fragment:Ew,lights_toon_pars_fragment:Tw,lights_phong_fragment:Cw,lights_phong_pars_fragment:Rw,lights_physical_fragment:Pw,lights_physical_pars_fragment:Iw,lights_fragment_begin:Lw,lights_fragment_maps:Nw,lights_fragment_end:Dw,lightprobes_pars_fragment:kw,logdepthbuf_fragment:Ow,logdepthbuf_pars_fragment:Uw,logdepthbuf_pars_vertex:Fw,logdepthbuf_vertex:Bw,map_fragment:zw,map_pars_fragment:Vw,map_particle_fragment:Gw,map_particle_pars_fragment:Hw,metalnessmap_fragment:Ww,metalnessmap_pars_fragment:$w,morphinstance_vertex:Xw,morphcolor_vertex:qw,morphnormal_vertex:Yw,morphtarget_pars_vertex:Zw,morphtarget_vertex:jw,normal_fragment_begin:Kw,normal_fragment_maps:Jw,normal_pars_fragment:Qw,normal_pars_vertex:eM,normal_vertex:tM,normalmap_pars_fragment:nM,clearcoat_normal_fragment_begin:iM,clearcoat_normal_fragment_maps:sM,clearcoat_pars_fragment:rM,iridescence_pars_fragment:oM,opaque_fragment:aM,packing:lM,premultiplied_alpha_fragment:cM,project_vertex:uM,dithering_fragment:hM,dithering_pars_fragment:dM,roughnessmap_fragment:fM,roughnessmap_pars_fragment:pM,shadowmap_pars_fragment:mM,shadowmap_pars_vertex:gM,shadowmap_vertex:xM,shadowmask_pars_fragment:_M,skinbase_vertex:yM,skinning_pars_vertex:vM,skinning_vertex:bM,skinnormal_vertex:SM,specularmap_fragment:wM,specularmap_pars_fragment:MM,tonemapping_fragment:AM,tonemapping_pars_fragment:EM,transmission_fragment:TM,transmission_pars_fragment:CM,uv_pars_fragment:RM,uv_pars_vertex:PM,uv_vertex:IM,worldpos_vertex:LM,background_vert:NM,background_frag:DM,backgroundCube_vert:kM,backgroundCube_frag:OM,cube_vert:UM,cube_frag:FM,depth_vert:BM,depth_frag:zM,distance_vert:VM,distance_frag:GM,equirect_vert:HM,equirect_frag:WM,linedashed_vert:$M,linedashed_frag:XM,meshbasic_vert:qM,meshbasic_frag:YM,meshlambert_vert:ZM,meshlambert_frag:jM,meshmatcap_vert:KM,meshmatcap_frag:JM,meshnormal_vert:QM,meshnormal_frag:e1,meshphong_vert:t1,meshphong_frag:n1,meshphysical_vert:i1,meshphysical_frag:s1,meshtoon_vert:r1,meshtoon_frag:o1,points_vert:a1,points_frag:l1,shadow_vert:c1,shadow_frag:u1,sprite_vert:h1,sprite_frag:d1},Ne={common:{diffuse:{value:new je(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new rt},alphaMap:{value:null},alphaMapTransform:{value:new rt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new rt}},envmap:{envMap:{value:null},envMapRotation:{value:new rt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new rt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new rt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new rt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new rt},normalScale:{value:new Je(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new rt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new rt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new rt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new rt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new je(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new je(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new rt},alphaTest:{value:0},uvTransform:{value:new rt}},sprite:{diffuse:{value:new je(16777215)},opacity:{value:1},center:{value:new Je(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new rt},alphaMap:{value:null},alphaMapTransform:{value:new rt},alphaTest:{value:0}}},rs={basic:{uniforms:Vn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.fog]),vertexShader:pt.meshbasic_vert,fragmentShader:pt.meshbasic_frag},lambert:{uniforms:Vn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new je(0)},envMapIntensity:{value:1}}]),vertexShader:pt.meshlambert_vert,fragmentShader:pt.meshlambert_frag},phong:{uniforms:Vn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new je(0)},specular:{value:new je(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:pt.meshphong_vert,fragmentShader:pt.meshphong_frag},standard:{uniforms:Vn([Ne.common,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.roughnessmap,Ne.metalnessmap,Ne.fog,Ne.lights,{emissive:{value:new je(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:pt.meshphysical_vert,fragmentShader:pt.meshphysical_frag},toon:{uniforms:Vn([Ne.common,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.gradientmap,Ne.fog,Ne.lights,{emissive:{value:new je(0)}}]),vertexShader:pt.meshtoon_vert,fragmentShader:pt.meshtoon_frag},matcap:{uniforms:Vn([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,{matcap:{value:null}}]),vertexShader:pt.meshmatcap_vert,fragmentShader:pt.meshmatcap_frag},points:{uniforms:Vn([Ne.points,Ne.fog]),vertexShader:pt.points_vert,fragmentShader:pt.points_frag},dashed:{uniforms:Vn([Ne.common,Ne.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:pt.linedashed_vert,fragmentShader:pt.linedashed_frag},depth:{uniforms:Vn([Ne.common,Ne.displacementmap]),vertexShader:pt.depth_vert,fragmentShader:pt.depth_frag},normal:{uniforms:Vn([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,{opacity:{value:1}}]),vertexShader:pt.meshnormal_vert,fragmentShader:pt.meshnormal_frag},sprite:{uniforms:Vn([Ne.sprite,Ne.fog]),vertexShader:pt.sprite_vert,fragmentShader:pt.sprite_frag},background:{uniforms:{uvTransform:{value:new rt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:pt.background_vert,fragmentShader:pt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new rt}},vertexShader:pt.backgroundCube_vert,fragmentShader:pt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:pt.cube_vert,fragmentShader:pt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:pt.equirect_vert,fragmentShader:pt.equirect_frag},distance:{uniforms:Vn([Ne.common,Ne.displacementmap,{referencePosition:{value:new G},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:pt.distance_vert,fragmentShader:pt.distance_frag},shadow:{uniforms:Vn([Ne.lights,Ne.fog,{color:{value:new je(0)},opacity:{value:1}}]),vertexShader:pt.shadow_vert,fragmentShader:pt.shadow_frag}};rs.physical={uniforms:Vn([rs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new rt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new rt},clearcoatNormalScale:{value:new Je(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new rt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new rt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new rt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new rt},sheen:{value:0},sheenColor:{value:new je(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new rt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new rt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new rt},transmissionSamplerSize:{value:new Je},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new rt},attenuationDistance:{value:0},attenuationColor:{value:new je(0)},specularColor:{value:new je(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new rt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new rt},anisotropyVector:{value:new Je},anisotropyMap:{value:null},anisotropyMapTransform:{value:new rt}}]),vertexShader:pt.meshphysical_vert,fragmentShader:pt.meshphysical_frag};var vu={r:0,b:0,g:0},f1=new dt,f0=new rt;f0.set(-1,0,0,0,1,0,0,0,1);function p1(n,e,t,i,s,r){let o=new je(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function f(_){let w=_.isScene===!0?_.background:null;if(w&&w.isTexture){let S=_.backgroundBlurriness>0;w=e.get(w,S)}return w}function p(_){let w=!1,S=f(_);S===null?m(o,a):S&&S.isColor&&(m(S,1),w=!0);let A=n.xr.getEnvironmentBlendMode();A==="additive"?t.buffers.color.setClear(0,0,0,1,r):A==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||w)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(_,w){let S=f(w);S&&S.isCubeTexture?(c===void 0&&(c=new _n(new Mo(1,1,1),new ns({name:"BackgroundCubeMaterial",uniforms:Lr(rs.backgroundCube.uniforms),vertexShader:rs.backgroundCube.vertexShader,fragmentShader:rs.backgroundCube.fragmentShader,side:jn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(A,M,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=w.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(f1.makeRotationFromEuler(w.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(f0),c.material.toneMapped=St.getTransfer(S.colorSpace)!==Dt,(h!==S||u!==S.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,h=S,u=S.version,d=n.toneMapping),c.layers.enableAll(),_.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new _n(new Da(2,2),new ns({name:"BackgroundMaterial",uniforms:Lr(rs.background.uniforms),vertexShader:rs.background.vertexShader,fragmentShader:rs.background.fragmentShader,side:nr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,l.material.toneMapped=St.getTransfer(S.colorSpace)!==Dt,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(h!==S||u!==S.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,h=S,u=S.version,d=n.toneMapping),l.layers.enableAll(),_.unshift(l,l.geometry,l.material,0,0,null))}function m(_,w){_.getRGB(vu,nf(n)),t.buffers.color.setClear(vu.r,vu.g,vu.b,w,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(_,w=1){o.set(_),a=w,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(_){a=_,m(o,a)},render:p,addToRenderList:x,dispose:g}}function m1(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(C,D,U,N,z){let W=!1,H=u(C,N,U,D);r!==H&&(r=H,c(r.object)),W=f(C,N,U,z),W&&p(C,N,U,z),z!==null&&e.update(z,n.ELEMENT_ARRAY_BUFFER),(W||o)&&(o=!1,S(C,D,U,N),z!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(z).buffer))}function l(){return n.createVertexArray()}function c(C){return n.bindVertexArray(C)}function h(C){return n.deleteVertexArray(C)}function u(C,D,U,N){let z=N.wireframe===!0,W=i[D.id];W===void 0&&(W={},i[D.id]=W);let H=C.isInstancedMesh===!0?C.id:0,se=W[H];se===void 0&&(se={},W[H]=se);let Y=se[U.id];Y===void 0&&(Y={},se[U.id]=Y);let J=Y[z];return J===void 0&&(J=d(l()),Y[z]=J),J}function d(C){let D=[],U=[],N=[];for(let z=0;z<t;z++)D[z]=0,U[z]=0,N[z]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:D,enabledAttributes:U,attributeDivisors:N,object:C,attributes:{},index:null}}function f(C,D,U,N){let z=r.attributes,W=D.attributes,H=0,se=U.getAttributes();for(let Y in se)if(se[Y].location>=0){let te=z[Y],pe=W[Y];if(pe===void 0&&(Y==="instanceMatrix"&&C.instanceMatrix&&(pe=C.instanceMatrix),Y==="instanceColor"&&C.instanceColor&&(pe=C.instanceColor)),te===void 0||te.attribute!==pe||pe&&te.data!==pe.data)return!0;H++}return r.attributesNum!==H||r.index!==N}function p(C,D,U,N){let z={},W=D.attributes,H=0,se=U.getAttributes();for(let Y in se)if(se[Y].location>=0){let te=W[Y];te===void 0&&(Y==="instanceMatrix"&&C.instanceMatrix&&(te=C.instanceMatrix),Y==="instanceColor"&&C.instanceColor&&(te=C.instanceColor));let pe={};pe.attribute=te,te&&te.data&&(pe.data=te.data),z[Y]=pe,H++}r.attributes=z,r.attributesNum=H,r.index=N}function x(){let C=r.newAttributes;for(let D=0,U=C.length;D<U;D++)C[D]=0}function m(C){g(C,0)}function g(C,D){let U=r.newAttributes,N=r.enabledAttributes,z=r.attributeDivisors;U[C]=1,N[C]===0&&(n.enableVertexAttribArray(C),N[C]=1),z[C]!==D&&(n.vertexAttribDivisor(C,D),z[C]=D)}function _(){let C=r.newAttributes,D=r.enabledAttributes;for(let U=0,N=D.length;U<N;U++)D[U]!==C[U]&&(n.disableVertexAttribArray(U),D[U]=0)}function w(C,D,U,N,z,W,H){H===!0?n.vertexAttribIPointer(C,D,U,z,W):n.vertexAttribPointer(C,D,U,N,z,W)}function S(C,D,U,N){x();let z=N.attributes,W=U.getAttributes(),H=D.defaultAttributeValues;for(let se in W){let Y=W[se];if(Y.location>=0){let J=z[se];if(J===void 0&&(se==="instanceMatrix"&&C.instanceMatrix&&(J=C.instanceMatrix),se==="instanceColor"&&C.instanceColor&&(J=C.instanceColor)),J!==void 0){let te=J.normalized,pe=J.itemSize,fe=e.get(J);if(fe===void 0)continue;let ee=fe.buffer,he=fe.type,xe=fe.bytesPerElement,be=he===n.INT||he===n.UNSIGNED_INT||J.gpuType===Oc;if(J.isInterleavedBufferAttribute){let Se=J.data,$e=Se.isInterleavedBuffer===!0?Se.stride:Se.itemSize,ot=J.offset;if(Se.isInstancedInterleavedBuffer||Se.isInstancedBufferAttribute){for(let We=0;We<Y.locationSize;We++)g(Y.location+We,Se.meshPerAttribute);C.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Se.meshPerAttribute*Se.count)}else for(let We=0;We<Y.locationSize;We++)m(Y.location+We);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let We=0;We<Y.locationSize;We++)w(Y.location+We,pe/Y.locationSize,he,te,$e*xe,(ot+pe/Y.locationSize*We)*xe,be)}else{if(J.isInstancedBufferAttribute){for(let Se=0;Se<Y.locationSize;Se++)g(Y.location+Se,J.meshPerAttribute);C.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=J.meshPerAttribute*J.count)}else for(let Se=0;Se<Y.locationSize;Se++)m(Y.location+Se);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Se=0;Se<Y.locationSize;Se++)w(Y.location+Se,pe/Y.locationSize,he,te,pe*xe,pe/Y.locationSize*Se*xe,be)}}else if(H!==void 0){let te=H[se];if(te!==void 0)switch(te.length){case 2:n.vertexAttrib2fv(Y.location,te);break;case 3:n.vertexAttrib3fv(Y.location,te);break;case 4:n.vertexAttrib4fv(Y.location,te);break;default:n.vertexAttrib1fv(Y.location,te)}}}}_()}function A(){T();for(let C in i){let D=i[C];for(let U in D){let N=D[U];for(let z in N){let W=N[z];for(let H in W)h(W[H].object),delete W[H];delete N[z]}}delete i[C]}}function M(C){if(i[C.id]===void 0)return;let D=i[C.id];for(let U in D){let N=D[U];for(let z in N){let W=N[z];for(let H in W)h(W[H].object),delete W[H];delete N[z]}}delete i[C.id]}function y(C){for(let D in i){let U=i[D];for(let N in U){let z=U[N];if(z[C.id]===void 0)continue;let W=z[C.id];for(let H in W)h(W[H].object),delete W[H];delete z[C.id]}}}function b(C){for(let D in i){let U=i[D],N=C.isInstancedMesh===!0?C.id:0,z=U[N];if(z!==void 0){for(let W in z){let H=z[W];for(let se in H)h(H[se].object),delete H[se];delete z[W]}delete U[N],Object.keys(U).length===0&&delete i[D]}}}function T(){P(),o=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:T,resetDefaultState:P,dispose:A,releaseStatesOfGeometry:M,releaseStatesOfObject:b,releaseStatesOfProgram:y,initAttributes:x,enableAttribute:m,disableUnusedAttributes:_}}function g1(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,h){h!==0&&(n.drawArraysInstanced(i,l,c,h),t.update(c,i,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];t.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function x1(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let y=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==Ui&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let b=y===Oi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(y!==ti&&y!==Mi&&!b&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(Ke("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&Ke("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&Ke("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),_=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),w=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),A=n.getParameter(n.MAX_SAMPLES),M=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:p,maxTextureSize:x,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:_,maxVaryings:w,maxFragmentUniforms:S,maxSamples:A,samples:M}}function _1(n){let e=this,t=null,i=0,s=!1,r=!1,o=new ui,a=new rt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||i!==0||s;return s=d,i=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){t=h(u,d,0)},this.setState=function(u,d,f){let p=u.clippingPlanes,x=u.clipIntersection,m=u.clipShadows,g=n.get(u);if(!s||p===null||p.length===0||r&&!m)r?h(null):c();else{let _=r?0:i,w=_*4,S=g.clippingState||null;l.value=S,S=h(p,d,w,f);for(let A=0;A!==w;++A)S[A]=t[A];g.clippingState=S,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=_}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function h(u,d,f,p){let x=u!==null?u.length:0,m=null;if(x!==0){if(m=l.value,p!==!0||m===null){let g=f+x*4,_=d.matrixWorldInverse;a.getNormalMatrix(_),(m===null||m.length<g)&&(m=new Float32Array(g));for(let w=0,S=f;w!==x;++w,S+=4)o.copy(u[w]).applyMatrix4(_,a),o.normal.toArray(m,S),m[S+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=x,e.numIntersection=0,m}}var Qa=class extends di{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new Ia(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Mo(5,5,5),r=new ns({name:"CubemapFromEquirect",uniforms:Lr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:jn,blending:Cr});r.uniforms.tEquirect.value=t;let o=new _n(s,r),a=t.minFilter;return t.minFilter===Cs&&(t.minFilter=Zn),new Eo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},$g=256,y1=3,v1=20,p0=256,m0=16,b1=3,S1=new G,w1=new je,Su=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Eo(1,10,null),this._boxMesh=new _n(new Mo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=S1}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,x=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(e.background=l.getClearColor(w1));let m=new Eo(i,s,h);return m.position.copy(a),m.update(l,e),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,e.background=x,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Yg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=qg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max($g,Qd(e))}_fromTexture(e,t){e.mapping===Pr||e.mapping===Po?this._setSize(e.image.length===0?$g:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=Xg(e,!1,!1),i=Math.log2(e)-y1;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Xg(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Pr||e.mapping===Po?(this._cubemapMaterial===null&&(this._cubemapMaterial=Yg()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=qg()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=M1(),this._integrationMaterial=A1());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/m0);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-b1)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(p0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=E1());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function Xg(n,e,t){return new Qa(n,{minFilter:Cs,generateMipmaps:e,type:Oi,colorSpace:Sa,depthBuffer:t})}function el(n,e,t){return new ns({name:n,uniforms:e,vertexShader:pt.cube_vert,fragmentShader:t,side:jn,blending:Cr,depthTest:!1,depthWrite:!1})}function M1(){return el("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${p0}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function A1(){return el("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:m0}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function E1(){return el("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${v1}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function qg(){return el("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Yg(){return el("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function T1(n){let e=new WeakMap,t=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Nc||f===Dc)if(e.has(d)){let p=e.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let x=new Qa(p.height);return x.fromEquirectangularTexture(n,d),e.set(d,x),d.addEventListener("dispose",c),a(x.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===Nc||f===Dc,x=f===Pr||f===Po;if(p||x){let m=t.get(d),g=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return i===null&&(i=new Su(n)),m=p?i.fromEquirectangular(d,m):i.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),m.texture;if(m!==void 0)return m.texture;{let _=d.image;return p&&_&&_.height>0||x&&_&&l(_)?(i===null&&(i=new Su(n)),m=p?i.fromEquirectangular(d):i.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),d.addEventListener("dispose",h),m.texture):null}}}return d}function a(d,f){return f===Nc?d.mapping=Pr:f===Dc&&(d.mapping=Po),d}function l(d){let f=0,p=6;for(let x=0;x<p;x++)d[x]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function u(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:u}}function C1(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&_a("WebGLRenderer: "+i+" extension not supported."),s}}}function R1(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let m in p.attributes)e.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let x=r.get(p);x&&(e.remove(x),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),t.memory.geometries++),x}function h(p){let x=p.attributes;for(let m in x)e.update(x[m],n.ARRAY_BUFFER)}function u(p){let x=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let _=x!==null?x.array.length:m.array.length/3-1,w=m.count>=65535?Ca:Ta,S=new w(Math.ceil(_/3)*6,1),A=S.array;if(x!==null){let y=x.array;g=x.version;for(let b=0,T=0;b<_;b+=3){let P=y[b+0],C=y[b+1],D=y[b+2];A[T++]=P,A[T++]=C,A[T++]=C,A[T++]=D,A[T++]=D,A[T++]=P}}else{g=m.version;for(let y=0,b=0;y<_;y+=3){let T=y+0,P=y+1,C=y+2;A[b++]=T,A[b++]=P,A[b++]=P,A[b++]=C,A[b++]=C,A[b++]=T}}S.version=g;let M=r.get(p);M&&e.remove(M),r.set(p,S)}function d(p){let x=r.get(p);if(x){let m=p.index;m!==null&&x.version<m.version&&u(p)}else u(p);return r.get(p)}function f(){for(let p in s){let x=s[p].deref();x!==void 0&&l(x)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function P1(n,e,t){let i;function s(u){i=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){n.drawElements(i,d,r,u*o),t.update(d,i,1)}function c(u,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,u*o,f),t.update(d,i,f))}function h(u,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,u,0,f);let x=0;for(let m=0;m<f;m++)x+=d[m];t.update(x,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function I1(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:st("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function L1(n,e,t){let i=new WeakMap,s=new Gt;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=i.get(a);if(d===void 0||d.count!==u){let T=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",T)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],_=a.morphAttributes.color||[],w=0;f===!0&&(w=1),p===!0&&(w=2),x===!0&&(w=3);let S=a.attributes.position.count*w,A=1;S>e.maxTextureSize&&(A=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let M=new Float32Array(S*A*4*u),y=new Aa(M,S,A,u);y.type=Mi,y.needsUpdate=!0;let b=w*4;for(let P=0;P<u;P++){let C=m[P],D=g[P],U=_[P],N=S*A*4*P;for(let z=0;z<C.count;z++){let W=z*b;f===!0&&(s.fromBufferAttribute(C,z),M[N+W+0]=s.x,M[N+W+1]=s.y,M[N+W+2]=s.z,M[N+W+3]=0),p===!0&&(s.fromBufferAttribute(D,z),M[N+W+4]=s.x,M[N+W+5]=s.y,M[N+W+6]=s.z,M[N+W+7]=0),x===!0&&(s.fromBufferAttribute(U,z),M[N+W+8]=s.x,M[N+W+9]=s.y,M[N+W+10]=s.z,M[N+W+11]=U.itemSize===4?s.w:1)}}d={count:u,texture:y,size:new Je(S,A)},i.set(a,d),a.addEventListener("dispose",T)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let f=0;for(let x=0;x<c.length;x++)f+=c[x];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function N1(n,e,t,i,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=e.get(c,u);if(r.get(d)!==h&&(e.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),i.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var D1={[Id]:"LINEAR_TONE_MAPPING",[Ld]:"REINHARD_TONE_MAPPING",[Nd]:"CINEON_TONE_MAPPING",[Dd]:"ACES_FILMIC_TONE_MAPPING",[Od]:"AGX_TONE_MAPPING",[Ud]:"NEUTRAL_TONE_MAPPING",[kd]:"CUSTOM_TONE_MAPPING"};function k1(n,e,t,i,s,r){let o=new di(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new bn;h.setAttribute("position",new an([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new an([0,2,0,0,2,0],2));let u=new xc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new _n(h,u),f=new Ba(-1,1,1,-1,0,1),p=null,x=null,m=!1,g,_=null,w=[],S=!1;this.setSize=function(A,M){o.setSize(A,M),a!==null&&a.setSize(A,M),l!==null&&l.setSize(A,M);for(let y=0;y<w.length;y++){let b=w[y];b.setSize&&b.setSize(A,M)}},this.setEffects=function(A){w=A,S=w.length>0&&w[0].isRenderPass===!0;let M=o.width,y=o.height;w.length>0&&a===null&&(a=new di(M,y,{type:Oi,depthBuffer:!1,stencilBuffer:!1}),l=new di(M,y,{type:Oi,depthBuffer:!1,stencilBuffer:!1}));let b=s===!0&&w.some(T=>T.needsDepthTexture===!0);b!==(o.depthTexture!==null)&&(b===!0&&c===null&&(c=new Es(M,y),r===!0&&(c.format=Rs,c.type=Ir)),o.dispose(),o.depthTexture=b?c:null,o.resolveDepthBuffer=b,o.storeMultisampledDepthBuffer=b);for(let T=0;T<w.length;T++){let P=w[T];P.setSize&&P.setSize(M,y),b&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(A,M){if(m||A.toneMapping===is&&w.length===0)return!1;if(_=M,M!==null){let y=M.width,b=M.height;(o.width!==y||o.height!==b)&&this.setSize(y,b)}return S===!1&&A.setRenderTarget(o),g=A.toneMapping,A.toneMapping=is,!0},this.hasRenderPass=function(){return S},this.end=function(A,M){A.toneMapping=g,m=!0;let y=o,b=a;for(let T=0;T<w.length;T++){let P=w[T];P.enabled!==!1&&(P.render(A,b,y,M),P.needsSwap!==!1&&(y=b,b=b===a?l:a))}if(p!==A.outputColorSpace||x!==A.toneMapping){p=A.outputColorSpace,x=A.toneMapping,u.defines={},St.getTransfer(p)===Dt&&(u.defines.SRGB_TRANSFER="");let T=D1[x];T&&(u.defines[T]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=y.texture,A.setRenderTarget(_),A.render(d,f),_=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var g0=new ei,x0=new Es(1,1),_0=new La(1),y0=new Aa,v0=new dc,b0=new Ia,Zg=[],jg=[],Kg=new Float32Array(16),Jg=new Float32Array(9),Qg=new Float32Array(4);function Do(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=Zg[s];if(r===void 0&&(r=new Float32Array(s),Zg[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function Sn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function wn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Mu(n,e){let t=jg[e];t===void 0&&(t=new Int32Array(e),jg[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function O1(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function U1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;n.uniform2fv(this.addr,e),wn(t,e)}}function F1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Sn(t,e))return;n.uniform3fv(this.addr,e),wn(t,e)}}function B1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;n.uniform4fv(this.addr,e),wn(t,e)}}function z1(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Sn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),wn(t,e)}else{if(Sn(t,i))return;Qg.set(i),n.uniformMatrix2fv(this.addr,!1,Qg),wn(t,i)}}function V1(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Sn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),wn(t,e)}else{if(Sn(t,i))return;Jg.set(i),n.uniformMatrix3fv(this.addr,!1,Jg),wn(t,i)}}function G1(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Sn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),wn(t,e)}else{if(Sn(t,i))return;Kg.set(i),n.uniformMatrix4fv(this.addr,!1,Kg),wn(t,i)}}function H1(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function W1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;n.uniform2iv(this.addr,e),wn(t,e)}}function $1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Sn(t,e))return;n.uniform3iv(this.addr,e),wn(t,e)}}function X1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;n.uniform4iv(this.addr,e),wn(t,e)}}function q1(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function Y1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;n.uniform2uiv(this.addr,e),wn(t,e)}}function Z1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Sn(t,e))return;n.uniform3uiv(this.addr,e),wn(t,e)}}function j1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;n.uniform4uiv(this.addr,e),wn(t,e)}}function Au(n){return n.version===0&&(n.compareFunction=Zd,n.needsUpdate=!0),n}function K1(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Au(x0):r=g0,t.setTexture2D(e||r,s)}function J1(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||v0,s)}function Q1(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Au(_0):r=b0,t.setTextureCube(e||r,s)}function eA(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||y0,s)}function tA(n){switch(n){case 5126:return O1;case 35664:return U1;case 35665:return F1;case 35666:return B1;case 35674:return z1;case 35675:return V1;case 35676:return G1;case 5124:case 35670:return H1;case 35667:case 35671:return W1;case 35668:case 35672:return $1;case 35669:case 35673:return X1;case 5125:return q1;case 36294:return Y1;case 36295:return Z1;case 36296:return j1;case 35678:case 36198:case 36298:case 36306:case 35682:return K1;case 35679:case 36299:case 36307:return J1;case 35680:case 36300:case 36308:case 36293:return Q1;case 36289:case 36303:case 36311:case 36292:return eA}}function nA(n,e){n.uniform1fv(this.addr,e)}function iA(n,e){let t=Do(e,this.size,2);n.uniform2fv(this.addr,t)}function sA(n,e){let t=Do(e,this.size,3);n.uniform3fv(this.addr,t)}function rA(n,e){let t=Do(e,this.size,4);n.uniform4fv(this.addr,t)}function oA(n,e){let t=Do(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function aA(n,e){let t=Do(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function lA(n,e){let t=Do(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function cA(n,e){n.uniform1iv(this.addr,e)}function uA(n,e){n.uniform2iv(this.addr,e)}function hA(n,e){n.uniform3iv(this.addr,e)}function dA(n,e){n.uniform4iv(this.addr,e)}function fA(n,e){n.uniform1uiv(this.addr,e)}function pA(n,e){n.uniform2uiv(this.addr,e)}function mA(n,e){n.uniform3uiv(this.addr,e)}function gA(n,e){n.uniform4uiv(this.addr,e)}function xA(n,e,t){let i=this.cache,s=e.length,r=Mu(t,s);Sn(i,r)||(n.uniform1iv(this.addr,r),wn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Au(x0):o=g0;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function _A(n,e,t){let i=this.cache,s=e.length,r=Mu(t,s);Sn(i,r)||(n.uniform1iv(this.addr,r),wn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||v0,r[o])}function yA(n,e,t){let i=this.cache,s=e.length,r=Mu(t,s);Sn(i,r)||(n.uniform1iv(this.addr,r),wn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Au(_0):o=b0;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function vA(n,e,t){let i=this.cache,s=e.length,r=Mu(t,s);Sn(i,r)||(n.uniform1iv(this.addr,r),wn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||y0,r[o])}function bA(n){switch(n){case 5126:return nA;case 35664:return iA;case 35665:return sA;case 35666:return rA;case 35674:return oA;case 35675:return aA;case 35676:return lA;case 5124:case 35670:return cA;case 35667:case 35671:return uA;case 35668:case 35672:return hA;case 35669:case 35673:return dA;case 5125:return fA;case 36294:return pA;case 36295:return mA;case 36296:return gA;case 35678:case 36198:case 36298:case 36306:case 35682:return xA;case 35679:case 36299:case 36307:return _A;case 35680:case 36300:case 36308:case 36293:return yA;case 36289:case 36303:case 36311:case 36292:return vA}}var cf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=tA(t.type)}},uf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=bA(t.type)}},hf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},af=/(\w+)(\])?(\[|\.)?/g;function e0(n,e){n.seq.push(e),n.map[e.id]=e}function SA(n,e,t){let i=n.name,s=i.length;for(af.lastIndex=0;;){let r=af.exec(i),o=af.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){e0(t,c===void 0?new cf(a,n,e):new uf(a,n,e));break}else{let u=t.map[a];u===void 0&&(u=new hf(a),e0(t,u)),t=u}}}var No=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);SA(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function t0(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var wA=37297,MA=0;function AA(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var n0=new rt;function EA(n){St._getMatrix(n0,St.workingColorSpace,n);let e=`mat3( ${n0.elements.map(t=>t.toFixed(4))} )`;switch(St.getTransfer(n)){case wa:return[e,"LinearTransferOETF"];case Dt:return[e,"sRGBTransferOETF"];default:return Ke("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function i0(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+AA(n.getShaderSource(e),a)}else return r}function TA(n,e){let t=EA(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var CA={[Id]:"Linear",[Ld]:"Reinhard",[Nd]:"Cineon",[Dd]:"ACESFilmic",[Od]:"AgX",[Ud]:"Neutral",[kd]:"Custom"};function RA(n,e){let t=CA[e];return t===void 0?(Ke("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var bu=new G;function PA(){St.getLuminanceCoefficients(bu);let n=bu.x.toFixed(4),e=bu.y.toFixed(4),t=bu.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function IA(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ja).join(`
`)}function LA(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function NA(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Ja(n){return n!==""}function s0(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function r0(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var DA=/^[ \t]*#include +<([\w\d./]+)>/gm;function df(n){return n.replace(DA,kA)}function kA(n,e){let t=pt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return df(t)}var OA=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function o0(n){return n.replace(OA,UA)}function UA(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function a0(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var FA={[Ga]:"SHADOWMAP_TYPE_PCF",[Co]:"SHADOWMAP_TYPE_VSM"};function BA(n){return FA[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var zA={[Po]:"ENVMAP_MODE_REFRACTION"};function VA(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":zA[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var GA={[Lc]:"ENVMAP_BLENDING_MULTIPLY",[wg]:"ENVMAP_BLENDING_MIX",[Mg]:"ENVMAP_BLENDING_ADD"};function HA(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":GA[n.combine]||"ENVMAP_BLENDING_NONE"}function WA(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=BA(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=VA(t),u=HA(t),d=IA(t),f=LA(r),p=s.createProgram(),x,m,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(x=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Ja).join(`
`),x.length>0&&(x+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Ja).join(`
`),m.length>0&&(m+=`
`)):(x=[a0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ja).join(`
`),m=[a0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==is?"#define TONE_MAPPING":"",t.toneMapping!==is?pt.tonemapping_pars_fragment:"",t.toneMapping!==is?RA("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",pt.colorspace_pars_fragment,TA("linearToOutputTexel",t.outputColorSpace),PA(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Ja).join(`
`)),o=df(o),o=s0(o,t),o=r0(o,t),a=df(a),a=s0(a,t),a=r0(a,t),o=o0(o),a=o0(a),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,m=["#define varying in",t.glslVersion===jd?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===jd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let _=g+x+o,w=g+m+a,S=t0(s,s.VERTEX_SHADER,_),A=t0(s,s.FRAGMENT_SHADER,w);s.attachShader(p,S),s.attachShader(p,A),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function M(P){if(n.debug.checkShaderErrors){let C=s.getProgramInfoLog(p)||"",D=s.getShaderInfoLog(S)||"",U=s.getShaderInfoLog(A)||"",N=C.trim(),z=D.trim(),W=U.trim(),H=!0,se=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(H=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,S,A);else{let Y=i0(s,S,"vertex"),J=i0(s,A,"fragment");st("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+N+`
`+Y+`
`+J)}else N!==""?Ke("WebGLProgram: Program Info Log:",N):(z===""||W==="")&&(se=!1);se&&(P.diagnostics={runnable:H,programLog:N,vertexShader:{log:z,prefix:x},fragmentShader:{log:W,prefix:m}})}s.deleteShader(S),s.deleteShader(A),y=new No(s,p),b=NA(s,p)}let y;this.getUniforms=function(){return y===void 0&&M(this),y};let b;this.getAttributes=function(){return b===void 0&&M(this),b};let T=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return T===!1&&(T=s.getProgramParameter(p,wA)),T},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=MA++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=S,this.fragmentShader=A,this}var $A=0,ff=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new pf(e),t.set(e,i)),i}},pf=class{constructor(e){this.id=$A++,this.code=e,this.usedTimes=0}};function XA(n){return n===ir||n===Ya||n===Za}function qA(n,e,t,i,s,r){let o=new So,a=new ff,l=new Set,c=[],h=new Map,u=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function p(y,b,T,P,C,D){let U=P.fog,N=C.geometry,z=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?P.environment:null,W=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,H=e.get(y.envMap||z,W),se=d[y.type],Y=i.precision;y.precision!==null&&(Y=i.getMaxPrecision(y.precision),Y!==y.precision&&Ke("WebGLProgram.getParameters:",y.precision,"not supported, using",Y,"instead."));let J=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,te=J!==void 0?J.length:0,pe=0;N.morphAttributes.position!==void 0&&(pe=1),N.morphAttributes.normal!==void 0&&(pe=2),N.morphAttributes.color!==void 0&&(pe=3);let fe,ee,he,xe;if(se){let Pe=rs[se];fe=Pe.vertexShader,ee=Pe.fragmentShader}else{fe=y.vertexShader,ee=y.fragmentShader;let Pe=a.getVertexShaderStage(y),ht=a.getFragmentShaderStage(y);a.update(y,Pe,ht),he=Pe.id,xe=ht.id}let be=n.getRenderTarget(),Se=n.state.buffers.depth.getReversed(),$e=C.isInstancedMesh===!0,ot=C.isBatchedMesh===!0,We=!!y.map,lt=!!y.matcap,ct=!!H,et=ct&&H.isPMREMTexture===!0,$t=!!y.aoMap,Bt=!!y.lightMap,en=!!y.bumpMap&&y.wireframe===!1,At=!!y.normalMap,dn=!!y.displacementMap,vt=!!y.emissiveMap,we=!!y.metalnessMap,Fe=!!y.roughnessMap,Ze=y.anisotropy>0,B=y.clearcoat>0,de=y.diffuseRoughness>0,ke=y.dispersion>0,Qe=y.retroreflectivity>0,ye=y.iridescence>0,Et=y.sheen>0,ze=y.transmission>0,Ye=Ze&&!!y.anisotropyMap,k=B&&!!y.clearcoatMap,R=B&&!!y.clearcoatNormalMap,q=B&&!!y.clearcoatRoughnessMap,ce=de&&!!y.diffuseRoughnessMap,ae=ye&&!!y.iridescenceMap,ve=ye&&!!y.iridescenceThicknessMap,Me=Et&&!!y.sheenColorMap,ne=Et&&!!y.sheenRoughnessMap,re=!!y.specularMap,ge=!!y.specularColorMap,V=!!y.specularIntensityMap,oe=ze&&!!y.transmissionMap,ie=ze&&!!y.thicknessMap,Te=!!y.gradientMap,_e=!!y.alphaMap,Ee=y.alphaTest>0,Xe=!!y.alphaHash,nt=!!y.extensions,ue=is;y.toneMapped&&(be===null||be.isXRRenderTarget===!0)&&(ue=n.toneMapping);let Ve=et?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,it={shaderID:se,shaderType:y.type,shaderName:y.name,vertexShader:fe,fragmentShader:ee,defines:y.defines,customVertexShaderID:he,customFragmentShaderID:xe,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:Y,batching:ot,batchingColor:ot&&C._colorsTexture!==null,instancing:$e,instancingColor:$e&&C.instanceColor!==null,instancingMorph:$e&&C.morphTexture!==null,outputColorSpace:be===null?n.outputColorSpace:be.isXRRenderTarget===!0?be.texture.colorSpace:St.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:We,matcap:lt,envMap:ct,envMapMode:ct&&H.mapping,envMapPMREM:et,envMapMaxLod:et?Ve.length-1:null,envMapSize:et?Ve[0].width:null,aoMap:$t,lightMap:Bt,bumpMap:en,normalMap:At,displacementMap:dn,emissiveMap:vt,normalMapObjectSpace:At&&y.normalMapType===Tg,normalMapTangentSpace:At&&y.normalMapType===yu,packedNormalMap:At&&y.normalMapType===yu&&XA(y.normalMap.format),metalnessMap:we,roughnessMap:Fe,anisotropy:Ze,anisotropyMap:Ye,clearcoat:B,clearcoatMap:k,clearcoatNormalMap:R,clearcoatRoughnessMap:q,diffuseRoughness:de,diffuseRoughnessMap:ce,dispersion:ke,retroreflection:Qe,iridescence:ye,iridescenceMap:ae,iridescenceThicknessMap:ve,sheen:Et,sheenColorMap:Me,sheenRoughnessMap:ne,specularMap:re,specularColorMap:ge,specularIntensityMap:V,transmission:ze,transmissionMap:oe,thicknessMap:ie,gradientMap:Te,opaque:y.transparent===!1&&y.blending===Ro&&y.alphaToCoverage===!1,alphaMap:_e,alphaTest:Ee,alphaHash:Xe,combine:y.combine,mapUv:We&&f(y.map.channel),aoMapUv:$t&&f(y.aoMap.channel),lightMapUv:Bt&&f(y.lightMap.channel),bumpMapUv:en&&f(y.bumpMap.channel),normalMapUv:At&&f(y.normalMap.channel),displacementMapUv:dn&&f(y.displacementMap.channel),emissiveMapUv:vt&&f(y.emissiveMap.channel),metalnessMapUv:we&&f(y.metalnessMap.channel),roughnessMapUv:Fe&&f(y.roughnessMap.channel),anisotropyMapUv:Ye&&f(y.anisotropyMap.channel),clearcoatMapUv:k&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:R&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ce&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:ae&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:ve&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:Me&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:ne&&f(y.sheenRoughnessMap.channel),specularMapUv:re&&f(y.specularMap.channel),specularColorMapUv:ge&&f(y.specularColorMap.channel),specularIntensityMapUv:V&&f(y.specularIntensityMap.channel),transmissionMapUv:oe&&f(y.transmissionMap.channel),thicknessMapUv:ie&&f(y.thicknessMap.channel),alphaMapUv:_e&&f(y.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(At||Ze),vertexNormals:!!N.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:C.isPoints===!0&&!!N.attributes.uv&&(We||_e),fog:!!U,useFog:y.fog===!0,fogExp2:!!U&&U.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||N.attributes.normal===void 0&&At===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:Se,skinning:C.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:te,morphTextureStride:pe,numSunLights:b.sun.length,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numSunLightShadows:b.sunShadowMap.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numLightProbeGrids:D.filter(Pe=>Pe.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&T.length>0,shadowMapType:n.shadowMap.type,toneMapping:ue,decodeVideoTexture:We&&y.map.isVideoTexture===!0&&St.getTransfer(y.map.colorSpace)===Dt,decodeVideoTextureEmissive:vt&&y.emissiveMap.isVideoTexture===!0&&St.getTransfer(y.emissiveMap.colorSpace)===Dt,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===zn,flipSided:y.side===jn,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:nt&&y.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(nt&&y.extensions.multiDraw===!0||ot)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return it.vertexUv1s=l.has(1),it.vertexUv2s=l.has(2),it.vertexUv3s=l.has(3),l.clear(),it}function x(y){let b=[];if(y.shaderID?b.push(y.shaderID):(b.push(y.customVertexShaderID),b.push(y.customFragmentShaderID)),y.defines!==void 0)for(let T in y.defines)b.push(T),b.push(y.defines[T]);return y.isRawShaderMaterial===!1&&(m(b,y),g(b,y),b.push(n.outputColorSpace)),b.push(y.customProgramCacheKey),b.join()}function m(y,b){y.push(b.precision),y.push(b.outputColorSpace),y.push(b.envMapMode),y.push(b.envMapPMREM),y.push(b.envMapMaxLod),y.push(b.envMapSize),y.push(b.mapUv),y.push(b.alphaMapUv),y.push(b.lightMapUv),y.push(b.aoMapUv),y.push(b.bumpMapUv),y.push(b.normalMapUv),y.push(b.displacementMapUv),y.push(b.emissiveMapUv),y.push(b.metalnessMapUv),y.push(b.roughnessMapUv),y.push(b.anisotropyMapUv),y.push(b.clearcoatMapUv),y.push(b.clearcoatNormalMapUv),y.push(b.clearcoatRoughnessMapUv),y.push(b.diffuseRoughnessMapUv),y.push(b.iridescenceMapUv),y.push(b.iridescenceThicknessMapUv),y.push(b.sheenColorMapUv),y.push(b.sheenRoughnessMapUv),y.push(b.specularMapUv),y.push(b.specularColorMapUv),y.push(b.specularIntensityMapUv),y.push(b.transmissionMapUv),y.push(b.thicknessMapUv),y.push(b.combine),y.push(b.fogExp2),y.push(b.sizeAttenuation),y.push(b.morphTargetsCount),y.push(b.numSunLights),y.push(b.numDirLights),y.push(b.numPointLights),y.push(b.numSpotLights),y.push(b.numSpotLightMaps),y.push(b.numHemiLights),y.push(b.numRectAreaLights),y.push(b.numSunLightShadows),y.push(b.numDirLightShadows),y.push(b.numPointLightShadows),y.push(b.numSpotLightShadows),y.push(b.numSpotLightShadowsWithMaps),y.push(b.numLightProbes),y.push(b.numLightProbeGrids),y.push(b.shadowMapType),y.push(b.toneMapping),y.push(b.numClippingPlanes),y.push(b.numClipIntersection),y.push(b.depthPacking)}function g(y,b){o.disableAll(),b.instancing&&o.enable(0),b.instancingColor&&o.enable(1),b.instancingMorph&&o.enable(2),b.matcap&&o.enable(3),b.envMap&&o.enable(4),b.normalMapObjectSpace&&o.enable(5),b.normalMapTangentSpace&&o.enable(6),b.clearcoat&&o.enable(7),b.iridescence&&o.enable(8),b.alphaTest&&o.enable(9),b.vertexColors&&o.enable(10),b.vertexAlphas&&o.enable(11),b.vertexUv1s&&o.enable(12),b.vertexUv2s&&o.enable(13),b.vertexUv3s&&o.enable(14),b.vertexTangents&&o.enable(15),b.anisotropy&&o.enable(16),b.alphaHash&&o.enable(17),b.batching&&o.enable(18),b.dispersion&&o.enable(19),b.retroreflection&&o.enable(24),b.diffuseRoughness&&o.enable(25),b.batchingColor&&o.enable(20),b.gradientMap&&o.enable(21),b.packedNormalMap&&o.enable(22),b.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),b.fog&&o.enable(0),b.useFog&&o.enable(1),b.flatShading&&o.enable(2),b.logarithmicDepthBuffer&&o.enable(3),b.reversedDepthBuffer&&o.enable(4),b.skinning&&o.enable(5),b.morphTargets&&o.enable(6),b.morphNormals&&o.enable(7),b.morphColors&&o.enable(8),b.premultipliedAlpha&&o.enable(9),b.shadowMapEnabled&&o.enable(10),b.doubleSided&&o.enable(11),b.flipSided&&o.enable(12),b.useDepthPacking&&o.enable(13),b.dithering&&o.enable(14),b.transmission&&o.enable(15),b.sheen&&o.enable(16),b.opaque&&o.enable(17),b.pointsUvs&&o.enable(18),b.decodeVideoTexture&&o.enable(19),b.decodeVideoTextureEmissive&&o.enable(20),b.alphaToCoverage&&o.enable(21),b.numLightProbeGrids>0&&o.enable(22),b.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function _(y){let b=d[y.type],T;if(b){let P=rs[b];T=Gg.clone(P.uniforms)}else T=y.uniforms;return T}function w(y,b){let T=h.get(b);return T!==void 0?++T.usedTimes:(T=new WA(n,b,y,s),c.push(T),h.set(b,T)),T}function S(y){if(--y.usedTimes===0){let b=c.indexOf(y);c[b]=c[c.length-1],c.pop(),h.delete(y.cacheKey),y.destroy()}}function A(y){a.remove(y)}function M(){a.dispose()}return{getParameters:p,getProgramCacheKey:x,getUniforms:_,acquireProgram:w,releaseProgram:S,releaseShaderCache:A,programs:c,dispose:M}}function YA(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function ZA(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function l0(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function c0(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,x,m,g){let _=n[e];return _===void 0?(_={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:x,renderOrder:d.renderOrder,z:m,group:g},n[e]=_):(_.id=d.id,_.object=d,_.geometry=f,_.material=p,_.materialVariant=o(d),_.groupOrder=x,_.renderOrder=d.renderOrder,_.z=m,_.group=g),e++,_}function l(d,f,p,x,m,g,_){_.reversedDepth===!0&&(m=-m);let w=a(d,f,p,x,m,g);p.transmission>0?i.push(w):p.transparent===!0?s.push(w):t.push(w)}function c(d,f,p,x,m,g){let _=a(d,f,p,x,m,g);p.transmission>0?i.unshift(_):p.transparent===!0?s.unshift(_):t.unshift(_)}function h(d,f){t.length>1&&t.sort(d||ZA),i.length>1&&i.sort(f||l0),s.length>1&&s.sort(f||l0)}function u(){for(let d=e,f=n.length;d<f;d++){let p=n[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function jA(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new c0,n.set(i,[o])):s>=r.length?(o=new c0,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function KA(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new G,color:new je};break;case"SpotLight":t={position:new G,direction:new G,color:new je,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new G,color:new je,distance:0,decay:0};break;case"HemisphereLight":t={direction:new G,skyColor:new je,groundColor:new je};break;case"RectAreaLight":t={color:new je,position:new G,halfWidth:new G,halfHeight:new G};break}return n[e.id]=t,t}}}function JA(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Je};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Je};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Je,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var QA=0;function eE(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function tE(n){let e=new KA,t=JA(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new G);let s=new G,r=new dt,o=new dt;function a(c){let h=0,u=0,d=0;for(let D=0;D<9;D++)i.probe[D].set(0,0,0);let f=0,p=0,x=0,m=0,g=0,_=0,w=0,S=0,A=0,M=0,y=0,b=0,T=0,P=0;c.sort(eE);for(let D=0,U=c.length;D<U;D++){let N=c[D],z=N.color,W=N.intensity,H=N.distance,se=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===ir?se=N.shadow.map.texture:se=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)h+=z.r*W,u+=z.g*W,d+=z.b*W;else if(N.isLightProbe){for(let Y=0;Y<9;Y++)i.probe[Y].addScaledVector(N.sh.coefficients[Y],W);P++}else if(N.isSunLight){let Y=e.get(N);if(Y.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let J=N.shadow,te=t.get(N);te.shadowIntensity=J.intensity,te.shadowBias=J.bias,te.shadowNormalBias=J.normalBias,te.shadowRadius=J.radius,te.shadowMapSize.copy(J.mapSize).multiply(J.getFrameExtents()),i.sunShadow[p]=te,i.sunShadowMap[p]=se;let pe=J.getViewportCount();for(let fe=0;fe<pe;fe++)i.sunShadowMatrix[x+fe]=J.getMatrix(fe),i.sunShadowCascade[x+fe]=J._cascadeData[fe];x+=pe,p++}i.sun[f]=Y,f++}else if(N.isDirectionalLight){let Y=e.get(N);if(Y.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let J=N.shadow,te=t.get(N);te.shadowIntensity=J.intensity,te.shadowBias=J.bias,te.shadowNormalBias=J.normalBias,te.shadowRadius=J.radius,te.shadowMapSize=J.mapSize,i.directionalShadow[m]=te,i.directionalShadowMap[m]=se,i.directionalShadowMatrix[m]=N.shadow.matrix,A++}i.directional[m]=Y,m++}else if(N.isSpotLight){let Y=e.get(N);Y.position.setFromMatrixPosition(N.matrixWorld),Y.color.copy(z).multiplyScalar(W),Y.distance=H,Y.coneCos=Math.cos(N.angle),Y.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),Y.decay=N.decay,i.spot[_]=Y;let J=N.shadow;if(N.map&&(i.spotLightMap[b]=N.map,b++,J.updateMatrices(N),N.castShadow&&T++),i.spotLightMatrix[_]=J.matrix,N.castShadow){let te=t.get(N);te.shadowIntensity=J.intensity,te.shadowBias=J.bias,te.shadowNormalBias=J.normalBias,te.shadowRadius=J.radius,te.shadowMapSize=J.mapSize,i.spotShadow[_]=te,i.spotShadowMap[_]=se,y++}_++}else if(N.isRectAreaLight){let Y=e.get(N);Y.color.copy(z).multiplyScalar(W),Y.halfWidth.set(N.width*.5,0,0),Y.halfHeight.set(0,N.height*.5,0),i.rectArea[w]=Y,w++}else if(N.isPointLight){let Y=e.get(N);if(Y.color.copy(N.color).multiplyScalar(N.intensity),Y.distance=N.distance,Y.decay=N.decay,N.castShadow){let J=N.shadow,te=t.get(N);te.shadowIntensity=J.intensity,te.shadowBias=J.bias,te.shadowNormalBias=J.normalBias,te.shadowRadius=J.radius,te.shadowMapSize=J.mapSize,te.shadowCameraNear=J.camera.near,te.shadowCameraFar=J.camera.far,i.pointShadow[g]=te,i.pointShadowMap[g]=se,i.pointShadowMatrix[g]=N.shadow.matrix,M++}i.point[g]=Y,g++}else if(N.isHemisphereLight){let Y=e.get(N);Y.skyColor.copy(N.color).multiplyScalar(W),Y.groundColor.copy(N.groundColor).multiplyScalar(W),i.hemi[S]=Y,S++}}w>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ne.LTC_FLOAT_1,i.rectAreaLTC2=Ne.LTC_FLOAT_2):(i.rectAreaLTC1=Ne.LTC_HALF_1,i.rectAreaLTC2=Ne.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=u,i.ambient[2]=d;let C=i.hash;(C.sunLength!==f||C.directionalLength!==m||C.pointLength!==g||C.spotLength!==_||C.rectAreaLength!==w||C.hemiLength!==S||C.numSunShadows!==p||C.numDirectionalShadows!==A||C.numPointShadows!==M||C.numSpotShadows!==y||C.numSpotMaps!==b||C.numLightProbes!==P)&&(i.sun.length=f,i.directional.length=m,i.spot.length=_,i.rectArea.length=w,i.point.length=g,i.hemi.length=S,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=A,i.directionalShadowMap.length=A,i.directionalShadowMatrix.length=A,i.pointShadow.length=M,i.pointShadowMap.length=M,i.pointShadowMatrix.length=M,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+b-T,i.spotLightMap.length=b,i.numSpotLightShadowsWithMaps=T,i.numLightProbes=P,C.sunLength=f,C.directionalLength=m,C.pointLength=g,C.spotLength=_,C.rectAreaLength=w,C.hemiLength=S,C.numSunShadows=p,C.numDirectionalShadows=A,C.numPointShadows=M,C.numSpotShadows=y,C.numSpotMaps=b,C.numLightProbes=P,i.version=QA++)}function l(c,h){let u=0,d=0,f=0,p=0,x=0,m=0,g=h.matrixWorldInverse;for(let _=0,w=c.length;_<w;_++){let S=c[_];if(S.isSunLight){let A=i.sun[u];A.direction.setFromMatrixPosition(S.matrixWorld),A.direction.transformDirection(g),u++}else if(S.isDirectionalLight){let A=i.directional[d];A.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),d++}else if(S.isSpotLight){let A=i.spot[p];A.position.setFromMatrixPosition(S.matrixWorld),A.position.applyMatrix4(g),A.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),p++}else if(S.isRectAreaLight){let A=i.rectArea[x];A.position.setFromMatrixPosition(S.matrixWorld),A.position.applyMatrix4(g),o.identity(),r.copy(S.matrixWorld),r.premultiply(g),o.extractRotation(r),A.halfWidth.set(S.width*.5,0,0),A.halfHeight.set(0,S.height*.5,0),A.halfWidth.applyMatrix4(o),A.halfHeight.applyMatrix4(o),x++}else if(S.isPointLight){let A=i.point[f];A.position.setFromMatrixPosition(S.matrixWorld),A.position.applyMatrix4(g),f++}else if(S.isHemisphereLight){let A=i.hemi[m];A.direction.setFromMatrixPosition(S.matrixWorld),A.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:i}}function u0(n){let e=new tE(n),t=[],i=[],s=[];function r(u){h.camera=u,t.length=0,i.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):t.push(u)}function a(u){i.push(u)}function l(){e.setup(t),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){e.setupView(t,u)}let h={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function nE(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new u0(n),e.set(s,[a])):r>=o.length?(a=new u0(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var iE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,sE=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,rE=[new G(1,0,0),new G(-1,0,0),new G(0,1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1)],oE=[new G(0,-1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1),new G(0,-1,0),new G(0,-1,0)],h0=new dt,Ka=new G,lf=new G;function aE(n,e,t){let i=new Zs,s=new Je,r=new Je,o=new Gt,a=new _c,l=new yc,c={},h=t.maxTextureSize,u={[nr]:jn,[jn]:nr,[zn]:zn},d=new ns({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Je},radius:{value:4}},vertexShader:iE,fragmentShader:sE}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new bn;p.setAttribute("position",new un(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new _n(p,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ga;let g=this.type;this.render=function(M,y,b){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||M.length===0)return;this.type===sg&&(Ke("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ga);let T=n.getRenderTarget(),P=n.getActiveCubeFace(),C=n.getActiveMipmapLevel(),D=n.state;D.setBlending(Cr),D.buffers.depth.getReversed()===!0?D.buffers.color.setClear(0,0,0,0):D.buffers.color.setClear(1,1,1,1),D.buffers.depth.setTest(!0),D.setScissorTest(!1);let U=g!==this.type;U&&y.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(z=>z.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,z=M.length;N<z;N++){let W=M[N],H=W.shadow;if(H===void 0){Ke("WebGLShadowMap:",W,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let se=H.getFrameExtents();s.multiply(se),r.copy(H.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/se.x),s.x=r.x*se.x,H.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/se.y),s.y=r.y*se.y,H.mapSize.y=r.y));let Y=n.state.buffers.depth.getReversed();if(H.camera._reversedDepth=Y,H.map===null||U===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===Co){if(W.isPointLight){Ke("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new di(s.x,s.y,{format:ir,type:Oi,minFilter:Zn,magFilter:Zn,generateMipmaps:!1}),H.map.texture.name=W.name+".shadowMap",H.map.depthTexture=new Es(s.x,s.y,Mi),H.map.depthTexture.name=W.name+".shadowMapDepth",H.map.depthTexture.format=bs,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Nn,H.map.depthTexture.magFilter=Nn}else W.isPointLight?(H.map=new Qa(s.x),H.map.depthTexture=new La(s.x,ki)):(H.map=new di(s.x,s.y),H.map.depthTexture=new Es(s.x,s.y,ki)),H.map.depthTexture.name=W.name+".shadowMap",H.map.depthTexture.format=bs,this.type===Ga?(H.map.depthTexture.compareFunction=Y?Yd:qd,H.map.depthTexture.minFilter=Zn,H.map.depthTexture.magFilter=Zn):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Nn,H.map.depthTexture.magFilter=Nn);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let J=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();W.isPointLight!==!0&&H.updateMatrices(W,b);let te=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:b.layers;for(let pe=0;pe<J;pe++){let fe=H.getCamera(pe);if(W.isPointLight){let ee=H.camera,he=H.matrix,xe=W.distance||ee.far;xe!==ee.far&&(ee.far=xe,ee.updateProjectionMatrix()),Ka.setFromMatrixPosition(W.matrixWorld),ee.position.copy(Ka),lf.copy(ee.position),lf.add(rE[pe]),ee.up.copy(oE[pe]),ee.lookAt(lf),ee.updateMatrixWorld(),he.makeTranslation(-Ka.x,-Ka.y,-Ka.z),h0.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),H._frustum.setFromProjectionMatrix(h0,ee.coordinateSystem,ee.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)n.setRenderTarget(H.map,pe),n.clear();else{pe===0&&(n.setRenderTarget(H.map),n.clear());let ee=H.getViewport(pe);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),D.viewport(o)}i=H.getFrustum(pe),S(y,b,fe,W,te,this.type)}H.isPointLightShadow!==!0&&this.type===Co&&_(H,b),H.needsUpdate=!1}g=this.type,m.needsUpdate=!1,n.setRenderTarget(T,P,C)};function _(M,y){let b=e.update(x);d.defines.VSM_SAMPLES!==M.blurSamples&&(d.defines.VSM_SAMPLES=M.blurSamples,f.defines.VSM_SAMPLES=M.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),M.mapPass===null?M.mapPass=new di(s.x,s.y,{format:ir,type:Oi}):(M.mapPass.width!==M.map.width||M.mapPass.height!==M.map.height)&&M.mapPass.setSize(M.map.width,M.map.height),d.uniforms.shadow_pass.value=M.map.depthTexture,d.uniforms.resolution.value.set(M.map.width,M.map.height),d.uniforms.radius.value=M.radius,n.setRenderTarget(M.mapPass),n.clear(),n.renderBufferDirect(y,null,b,d,x,null),f.uniforms.shadow_pass.value=M.mapPass.texture,f.uniforms.resolution.value.set(M.map.width,M.map.height),f.uniforms.radius.value=M.radius,n.setRenderTarget(M.map),n.clear(),n.renderBufferDirect(y,null,b,f,x,null)}function w(M,y,b,T){let P=null,C=b.isPointLight===!0?M.customDistanceMaterial:M.customDepthMaterial;if(C!==void 0)P=C;else if(P=b.isPointLight===!0?l:a,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let D=P.uuid,U=y.uuid,N=c[D];N===void 0&&(N={},c[D]=N);let z=N[U];z===void 0&&(z=P.clone(),N[U]=z,y.addEventListener("dispose",A)),P=z}if(P.visible=y.visible,P.wireframe=y.wireframe,T===Co?P.side=y.shadowSide!==null?y.shadowSide:y.side:P.side=y.shadowSide!==null?y.shadowSide:u[y.side],P.alphaMap=y.alphaMap,P.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,P.map=y.map,P.clipShadows=y.clipShadows,P.clippingPlanes=y.clippingPlanes,P.clipIntersection=y.clipIntersection,P.displacementMap=y.displacementMap,P.displacementScale=y.displacementScale,P.displacementBias=y.displacementBias,P.wireframeLinewidth=y.wireframeLinewidth,P.linewidth=y.linewidth,b.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let D=n.properties.get(P);D.light=b}return P}function S(M,y,b,T,P,C){if(M.visible===!1)return;if(M.layers.test(P)&&(M.isMesh||M.isLine||M.isPoints)&&(M.castShadow||M.receiveShadow&&C===Co)&&(!M.frustumCulled||M.intersectsFrustum(i))){M.modelViewMatrix.multiplyMatrices(b.matrixWorldInverse,M.matrixWorld);let N=e.update(M),z=M.material;if(Array.isArray(z)){let W=N.groups;for(let H=0,se=W.length;H<se;H++){let Y=W[H],J=z[Y.materialIndex];if(J&&J.visible){let te=w(M,J,T,C);M.onBeforeShadow(n,M,y,b,N,te,Y),n.renderBufferDirect(b,null,N,te,M,Y),M.onAfterShadow(n,M,y,b,N,te,Y)}}}else if(z.visible){let W=w(M,z,T,C);M.onBeforeShadow(n,M,y,b,N,W,null),n.renderBufferDirect(b,null,N,W,M,null),M.onAfterShadow(n,M,y,b,N,W,null)}}let U=M.children;for(let N=0,z=U.length;N<z;N++)S(U[N],y,b,T,P,C)}function A(M){M.target.removeEventListener("dispose",A);for(let b in c){let T=c[b],P=M.target.uuid;P in T&&(T[P].dispose(),delete T[P])}}}function lE(n,e){function t(){let V=!1,oe=new Gt,ie=null,Te=new Gt(0,0,0,0);return{setMask:function(_e){ie!==_e&&!V&&(n.colorMask(_e,_e,_e,_e),ie=_e)},setLocked:function(_e){V=_e},setClear:function(_e,Ee,Xe,nt,ue){ue===!0&&(_e*=nt,Ee*=nt,Xe*=nt),oe.set(_e,Ee,Xe,nt),Te.equals(oe)===!1&&(n.clearColor(_e,Ee,Xe,nt),Te.copy(oe))},reset:function(){V=!1,ie=null,Te.set(-1,0,0,0)}}}function i(){let V=!1,oe=!1,ie=null,Te=null,_e=null;return{setReversed:function(Ee){if(oe!==Ee){let Xe=e.get("EXT_clip_control");Ee?Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.ZERO_TO_ONE_EXT):Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.NEGATIVE_ONE_TO_ONE_EXT),oe=Ee;let nt=_e;_e=null,this.setClear(nt)}},getReversed:function(){return oe},setTest:function(Ee){Ee?Se(n.DEPTH_TEST):$e(n.DEPTH_TEST)},setMask:function(Ee){ie!==Ee&&!V&&(n.depthMask(Ee),ie=Ee)},setFunc:function(Ee){if(oe&&(Ee=Fg[Ee]),Te!==Ee){switch(Ee){case ec:n.depthFunc(n.NEVER);break;case tc:n.depthFunc(n.ALWAYS);break;case nc:n.depthFunc(n.LESS);break;case xo:n.depthFunc(n.LEQUAL);break;case ic:n.depthFunc(n.EQUAL);break;case sc:n.depthFunc(n.GEQUAL);break;case rc:n.depthFunc(n.GREATER);break;case oc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Te=Ee}},setLocked:function(Ee){V=Ee},setClear:function(Ee){_e!==Ee&&(_e=Ee,oe&&(Ee=1-Ee),n.clearDepth(Ee))},reset:function(){V=!1,ie=null,Te=null,_e=null,oe=!1}}}function s(){let V=!1,oe=null,ie=null,Te=null,_e=null,Ee=null,Xe=null,nt=null,ue=null;return{setTest:function(Ve){V||(Ve?Se(n.STENCIL_TEST):$e(n.STENCIL_TEST))},setMask:function(Ve){oe!==Ve&&!V&&(n.stencilMask(Ve),oe=Ve)},setFunc:function(Ve,it,Pe){(ie!==Ve||Te!==it||_e!==Pe)&&(n.stencilFunc(Ve,it,Pe),ie=Ve,Te=it,_e=Pe)},setOp:function(Ve,it,Pe){(Ee!==Ve||Xe!==it||nt!==Pe)&&(n.stencilOp(Ve,it,Pe),Ee=Ve,Xe=it,nt=Pe)},setLocked:function(Ve){V=Ve},setClear:function(Ve){ue!==Ve&&(n.clearStencil(Ve),ue=Ve)},reset:function(){V=!1,oe=null,ie=null,Te=null,_e=null,Ee=null,Xe=null,nt=null,ue=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,p=[],x=null,m=!1,g=null,_=null,w=null,S=null,A=null,M=null,y=null,b=new je(0,0,0),T=0,P=!1,C=null,D=null,U=null,N=null,z=null,W=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,se=0,Y=n.getParameter(n.VERSION);Y.indexOf("WebGL")!==-1?(se=parseFloat(/^WebGL (\d)/.exec(Y)[1]),H=se>=1):Y.indexOf("OpenGL ES")!==-1&&(se=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),H=se>=2);let J=null,te={},pe=n.getParameter(n.SCISSOR_BOX),fe=n.getParameter(n.VIEWPORT),ee=new Gt().fromArray(pe),he=new Gt().fromArray(fe);function xe(V,oe,ie,Te){let _e=new Uint8Array(4),Ee=n.createTexture();n.bindTexture(V,Ee),n.texParameteri(V,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(V,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Xe=0;Xe<ie;Xe++)V===n.TEXTURE_3D||V===n.TEXTURE_2D_ARRAY?n.texImage3D(oe,0,n.RGBA,1,1,Te,0,n.RGBA,n.UNSIGNED_BYTE,_e):n.texImage2D(oe+Xe,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,_e);return Ee}let be={};be[n.TEXTURE_2D]=xe(n.TEXTURE_2D,n.TEXTURE_2D,1),be[n.TEXTURE_CUBE_MAP]=xe(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),be[n.TEXTURE_2D_ARRAY]=xe(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),be[n.TEXTURE_3D]=xe(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Se(n.DEPTH_TEST),o.setFunc(xo),en(!1),At(Ad),Se(n.CULL_FACE),$t(Cr);function Se(V){h[V]!==!0&&(n.enable(V),h[V]=!0)}function $e(V){h[V]!==!1&&(n.disable(V),h[V]=!1)}function ot(V,oe){return d[V]!==oe?(n.bindFramebuffer(V,oe),d[V]=oe,V===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=oe),V===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=oe),!0):!1}function We(V,oe){let ie=p,Te=!1;if(V){ie=f.get(oe),ie===void 0&&(ie=[],f.set(oe,ie));let _e=V.textures;if(ie.length!==_e.length||ie[0]!==n.COLOR_ATTACHMENT0){for(let Ee=0,Xe=_e.length;Ee<Xe;Ee++)ie[Ee]=n.COLOR_ATTACHMENT0+Ee;ie.length=_e.length,Te=!0}}else ie[0]!==n.BACK&&(ie[0]=n.BACK,Te=!0);Te&&n.drawBuffers(ie)}function lt(V){return x!==V?(n.useProgram(V),x=V,!0):!1}let ct={[Rr]:n.FUNC_ADD,[og]:n.FUNC_SUBTRACT,[ag]:n.FUNC_REVERSE_SUBTRACT};ct[lg]=n.MIN,ct[cg]=n.MAX;let et={[ug]:n.ZERO,[hg]:n.ONE,[dg]:n.SRC_COLOR,[Rd]:n.SRC_ALPHA,[_g]:n.SRC_ALPHA_SATURATE,[gg]:n.DST_COLOR,[pg]:n.DST_ALPHA,[fg]:n.ONE_MINUS_SRC_COLOR,[Pd]:n.ONE_MINUS_SRC_ALPHA,[xg]:n.ONE_MINUS_DST_COLOR,[mg]:n.ONE_MINUS_DST_ALPHA,[yg]:n.CONSTANT_COLOR,[vg]:n.ONE_MINUS_CONSTANT_COLOR,[bg]:n.CONSTANT_ALPHA,[Sg]:n.ONE_MINUS_CONSTANT_ALPHA};function $t(V,oe,ie,Te,_e,Ee,Xe,nt,ue,Ve){if(V===Cr){m===!0&&($e(n.BLEND),m=!1);return}if(m===!1&&(Se(n.BLEND),m=!0),V!==rg){if(V!==g||Ve!==P){if((_!==Rr||A!==Rr)&&(n.blendEquation(n.FUNC_ADD),_=Rr,A=Rr),Ve)switch(V){case Ro:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Ed:n.blendFunc(n.ONE,n.ONE);break;case Td:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Cd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:st("WebGLState: Invalid blending: ",V);break}else switch(V){case Ro:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Ed:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Td:st("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Cd:st("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:st("WebGLState: Invalid blending: ",V);break}w=null,S=null,M=null,y=null,b.set(0,0,0),T=0,g=V,P=Ve}return}_e=_e||oe,Ee=Ee||ie,Xe=Xe||Te,(oe!==_||_e!==A)&&(n.blendEquationSeparate(ct[oe],ct[_e]),_=oe,A=_e),(ie!==w||Te!==S||Ee!==M||Xe!==y)&&(n.blendFuncSeparate(et[ie],et[Te],et[Ee],et[Xe]),w=ie,S=Te,M=Ee,y=Xe),(nt.equals(b)===!1||ue!==T)&&(n.blendColor(nt.r,nt.g,nt.b,ue),b.copy(nt),T=ue),g=V,P=!1}function Bt(V,oe){V.side===zn?$e(n.CULL_FACE):Se(n.CULL_FACE);let ie=V.side===jn;oe&&(ie=!ie),en(ie),V.blending===Ro&&V.transparent===!1?$t(Cr):$t(V.blending,V.blendEquation,V.blendSrc,V.blendDst,V.blendEquationAlpha,V.blendSrcAlpha,V.blendDstAlpha,V.blendColor,V.blendAlpha,V.premultipliedAlpha),o.setFunc(V.depthFunc),o.setTest(V.depthTest),o.setMask(V.depthWrite),r.setMask(V.colorWrite);let Te=V.stencilWrite;a.setTest(Te),Te&&(a.setMask(V.stencilWriteMask),a.setFunc(V.stencilFunc,V.stencilRef,V.stencilFuncMask),a.setOp(V.stencilFail,V.stencilZFail,V.stencilZPass)),vt(V.polygonOffset,V.polygonOffsetFactor,V.polygonOffsetUnits),V.alphaToCoverage===!0?Se(n.SAMPLE_ALPHA_TO_COVERAGE):$e(n.SAMPLE_ALPHA_TO_COVERAGE)}function en(V){C!==V&&(V?n.frontFace(n.CW):n.frontFace(n.CCW),C=V)}function At(V){V!==ng?(Se(n.CULL_FACE),V!==D&&(V===Ad?n.cullFace(n.BACK):V===ig?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):$e(n.CULL_FACE),D=V}function dn(V){V!==U&&(H&&n.lineWidth(V),U=V)}function vt(V,oe,ie){V?(Se(n.POLYGON_OFFSET_FILL),(N!==oe||z!==ie)&&(N=oe,z=ie,o.getReversed()&&(oe=-oe,ie=-ie),n.polygonOffset(oe,ie))):$e(n.POLYGON_OFFSET_FILL)}function we(V){V?Se(n.SCISSOR_TEST):$e(n.SCISSOR_TEST)}function Fe(V){V===void 0&&(V=n.TEXTURE0+W-1),J!==V&&(n.activeTexture(V),J=V)}function Ze(V,oe,ie){ie===void 0&&(J===null?ie=n.TEXTURE0+W-1:ie=J);let Te=te[ie];Te===void 0&&(Te={type:void 0,texture:void 0},te[ie]=Te),(Te.type!==V||Te.texture!==oe)&&(J!==ie&&(n.activeTexture(ie),J=ie),n.bindTexture(V,oe||be[V]),Te.type=V,Te.texture=oe)}function B(){let V=te[J];V!==void 0&&V.type!==void 0&&(n.bindTexture(V.type,null),V.type=void 0,V.texture=void 0)}function de(){try{n.compressedTexImage2D(...arguments)}catch(V){st("WebGLState:",V)}}function ke(){try{n.compressedTexImage3D(...arguments)}catch(V){st("WebGLState:",V)}}function Qe(){try{n.texSubImage2D(...arguments)}catch(V){st("WebGLState:",V)}}function ye(){try{n.texSubImage3D(...arguments)}catch(V){st("WebGLState:",V)}}function Et(){try{n.compressedTexSubImage2D(...arguments)}catch(V){st("WebGLState:",V)}}function ze(){try{n.compressedTexSubImage3D(...arguments)}catch(V){st("WebGLState:",V)}}function Ye(){try{n.texStorage2D(...arguments)}catch(V){st("WebGLState:",V)}}function k(){try{n.texStorage3D(...arguments)}catch(V){st("WebGLState:",V)}}function R(){try{n.texImage2D(...arguments)}catch(V){st("WebGLState:",V)}}function q(){try{n.texImage3D(...arguments)}catch(V){st("WebGLState:",V)}}function ce(V){return u[V]!==void 0?u[V]:n.getParameter(V)}function ae(V,oe){u[V]!==oe&&(n.pixelStorei(V,oe),u[V]=oe)}function ve(V){ee.equals(V)===!1&&(n.scissor(V.x,V.y,V.z,V.w),ee.copy(V))}function Me(V){he.equals(V)===!1&&(n.viewport(V.x,V.y,V.z,V.w),he.copy(V))}function ne(V,oe){let ie=c.get(oe);ie===void 0&&(ie=new WeakMap,c.set(oe,ie));let Te=ie.get(V);Te===void 0&&(Te=n.getUniformBlockIndex(oe,V.name),n.uniformBlockBinding(oe,Te,Te),ie.set(V,Te))}function re(V,oe,ie){let _e=c.get(oe).get(V);l[_e]!==ie&&(n.bindBufferBase(n.UNIFORM_BUFFER,_e,ie),l[_e]=ie)}function ge(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},u={},J=null,te={},d={},l={},f=new WeakMap,p=[],x=null,m=!1,g=null,_=null,w=null,S=null,A=null,M=null,y=null,b=new je(0,0,0),T=0,P=!1,C=null,D=null,U=null,N=null,z=null,ee.set(0,0,n.canvas.width,n.canvas.height),he.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Se,disable:$e,bindFramebuffer:ot,drawBuffers:We,useProgram:lt,setBlending:$t,setMaterial:Bt,setFlipSided:en,setCullFace:At,setLineWidth:dn,setPolygonOffset:vt,setScissorTest:we,activeTexture:Fe,bindTexture:Ze,unbindTexture:B,compressedTexImage2D:de,compressedTexImage3D:ke,texImage2D:R,texImage3D:q,pixelStorei:ae,getParameter:ce,updateUBOMapping:ne,uniformBlockBinding:re,texStorage2D:Ye,texStorage3D:k,texSubImage2D:Qe,texSubImage3D:ye,compressedTexSubImage2D:Et,compressedTexSubImage3D:ze,scissor:ve,viewport:Me,reset:ge}}function cE(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Je,h=new WeakMap,u=new Set,d,f=new WeakMap,p=new Set,x=new FinalizationRegistry(k=>p.delete(k)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(k,R){return m?new OffscreenCanvas(k,R):Ma("canvas")}function _(k,R,q){let ce=1,ae=Ye(k);if((ae.width>q||ae.height>q)&&(ce=q/Math.max(ae.width,ae.height)),ce<1)if(typeof HTMLImageElement<"u"&&k instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&k instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&k instanceof ImageBitmap||typeof VideoFrame<"u"&&k instanceof VideoFrame){let ve=Math.floor(ce*ae.width),Me=Math.floor(ce*ae.height);d===void 0&&(d=g(ve,Me));let ne=R?g(ve,Me):d;return ne.width=ve,ne.height=Me,ne.getContext("2d").drawImage(k,0,0,ve,Me),Ke("WebGLRenderer: Texture has been resized from ("+ae.width+"x"+ae.height+") to ("+ve+"x"+Me+")."),ne}else return"data"in k&&Ke("WebGLRenderer: Image in DataTexture is too big ("+ae.width+"x"+ae.height+")."),k;return k}function w(k){return k.generateMipmaps}function S(k){n.generateMipmap(k)}function A(k){return k.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:k.isWebGL3DRenderTarget?n.TEXTURE_3D:k.isWebGLArrayRenderTarget||k.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function M(k,R,q,ce,ae,ve=!1){if(k!==null){if(n[k]!==void 0)return n[k];Ke("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+k+"'")}let Me;ce&&(Me=e.get("EXT_texture_norm16"),Me||Ke("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ne=R;if(R===n.RED&&(q===n.FLOAT&&(ne=n.R32F),q===n.HALF_FLOAT&&(ne=n.R16F),q===n.UNSIGNED_BYTE&&(ne=n.R8),q===n.UNSIGNED_SHORT&&Me&&(ne=Me.R16_EXT),q===n.SHORT&&Me&&(ne=Me.R16_SNORM_EXT)),R===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(ne=n.R8UI),q===n.UNSIGNED_SHORT&&(ne=n.R16UI),q===n.UNSIGNED_INT&&(ne=n.R32UI),q===n.BYTE&&(ne=n.R8I),q===n.SHORT&&(ne=n.R16I),q===n.INT&&(ne=n.R32I)),R===n.RG&&(q===n.FLOAT&&(ne=n.RG32F),q===n.HALF_FLOAT&&(ne=n.RG16F),q===n.UNSIGNED_BYTE&&(ne=n.RG8),q===n.UNSIGNED_SHORT&&Me&&(ne=Me.RG16_EXT),q===n.SHORT&&Me&&(ne=Me.RG16_SNORM_EXT)),R===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(ne=n.RG8UI),q===n.UNSIGNED_SHORT&&(ne=n.RG16UI),q===n.UNSIGNED_INT&&(ne=n.RG32UI),q===n.BYTE&&(ne=n.RG8I),q===n.SHORT&&(ne=n.RG16I),q===n.INT&&(ne=n.RG32I)),R===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(ne=n.RGB8UI),q===n.UNSIGNED_SHORT&&(ne=n.RGB16UI),q===n.UNSIGNED_INT&&(ne=n.RGB32UI),q===n.BYTE&&(ne=n.RGB8I),q===n.SHORT&&(ne=n.RGB16I),q===n.INT&&(ne=n.RGB32I)),R===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(ne=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(ne=n.RGBA16UI),q===n.UNSIGNED_INT&&(ne=n.RGBA32UI),q===n.BYTE&&(ne=n.RGBA8I),q===n.SHORT&&(ne=n.RGBA16I),q===n.INT&&(ne=n.RGBA32I)),R===n.RGB&&(q===n.UNSIGNED_SHORT&&Me&&(ne=Me.RGB16_EXT),q===n.SHORT&&Me&&(ne=Me.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(ne=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(ne=n.R11F_G11F_B10F)),R===n.RGBA){let re=ve?wa:St.getTransfer(ae);q===n.FLOAT&&(ne=n.RGBA32F),q===n.HALF_FLOAT&&(ne=n.RGBA16F),q===n.UNSIGNED_BYTE&&(ne=re===Dt?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&Me&&(ne=Me.RGBA16_EXT),q===n.SHORT&&Me&&(ne=Me.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(ne=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(ne=n.RGB5_A1)}return(ne===n.R16F||ne===n.R32F||ne===n.RG16F||ne===n.RG32F||ne===n.RGBA16F||ne===n.RGBA32F)&&e.get("EXT_color_buffer_float"),ne}function y(k,R){let q;return k?R===null||R===ki||R===Ir?q=n.DEPTH24_STENCIL8:R===Mi?q=n.DEPTH32F_STENCIL8:R===Io&&(q=n.DEPTH24_STENCIL8,Ke("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):R===null||R===ki||R===Ir?q=n.DEPTH_COMPONENT24:R===Mi?q=n.DEPTH_COMPONENT32F:R===Io&&(q=n.DEPTH_COMPONENT16),q}function b(k,R){return w(k)===!0||k.isFramebufferTexture&&k.minFilter!==Nn&&k.minFilter!==Zn?Math.log2(Math.max(R.width,R.height))+1:k.mipmaps.length>0?k.mipmaps.length:k.isCompressedTexture&&Array.isArray(k.image)?R.mipmaps.length:1}function T(k){let R=new WeakRef(k);i.get(k).__ref=R,p.add(R),x.register(k,R,R)}function P(k){let R=i.get(k).__ref;R!==void 0&&(p.delete(R),x.unregister(R))}function C(k){U(k.target)}function D(k){N(k.target)}function U(k){k.removeEventListener("dispose",C),P(k),W(k),k.isVideoTexture&&h.delete(k),k.isHTMLTexture&&u.delete(k)}function N(k){k.removeEventListener("dispose",D),P(k),se(k)}function z(){for(let k of p){let R=k.deref();R!==void 0&&(R.isRenderTarget===!0?N(R):U(R))}p.clear(),u.clear()}function W(k){let R=i.get(k);if(R.__webglInit===void 0)return;let q=k.source,ce=f.get(q);if(ce){let ae=ce[R.__cacheKey];ae.usedTimes--,ae.usedTimes===0&&H(k),Object.keys(ce).length===0&&f.delete(q)}i.remove(k)}function H(k){let R=i.get(k);n.deleteTexture(R.__webglTexture);let q=k.source,ce=f.get(q);delete ce[R.__cacheKey],o.memory.textures--}function se(k){let R=i.get(k);R.__depthDisposeCallback&&R.__depthDisposeCallback();let q=k.depthTexture;if(q&&q.renderTarget===k&&U(q),k.isWebGLCubeRenderTarget)for(let ae=0;ae<6;ae++){if(Array.isArray(R.__webglFramebuffer[ae]))for(let ve=0;ve<R.__webglFramebuffer[ae].length;ve++)n.deleteFramebuffer(R.__webglFramebuffer[ae][ve]);else n.deleteFramebuffer(R.__webglFramebuffer[ae]);R.__webglDepthbuffer&&n.deleteRenderbuffer(R.__webglDepthbuffer[ae])}else{if(Array.isArray(R.__webglFramebuffer))for(let ae=0;ae<R.__webglFramebuffer.length;ae++)n.deleteFramebuffer(R.__webglFramebuffer[ae]);else n.deleteFramebuffer(R.__webglFramebuffer);if(R.__webglDepthbuffer&&n.deleteRenderbuffer(R.__webglDepthbuffer),R.__webglMultisampledFramebuffer&&n.deleteFramebuffer(R.__webglMultisampledFramebuffer),R.__webglColorRenderbuffer)for(let ae=0;ae<R.__webglColorRenderbuffer.length;ae++)R.__webglColorRenderbuffer[ae]&&n.deleteRenderbuffer(R.__webglColorRenderbuffer[ae]);R.__webglDepthRenderbuffer&&n.deleteRenderbuffer(R.__webglDepthRenderbuffer)}let ce=k.textures;for(let ae=0,ve=ce.length;ae<ve;ae++){let Me=i.get(ce[ae]);Me.__webglTexture&&(n.deleteTexture(Me.__webglTexture),o.memory.textures--),i.remove(ce[ae])}i.remove(k)}let Y=0;function J(){Y=0}function te(){return Y}function pe(k){Y=k}function fe(){let k=Y;return k>=s.maxTextures&&Ke("WebGLTextures: Trying to use "+(k+1)+" texture units while this GPU supports only "+s.maxTextures),Y+=1,k}function ee(k){let R=[];return R.push(k.wrapS),R.push(k.wrapT),R.push(k.wrapR||0),R.push(k.magFilter),R.push(k.minFilter),R.push(k.anisotropy),R.push(k.internalFormat),R.push(k.format),R.push(k.type),R.push(k.generateMipmaps),R.push(k.mipmapsAutoUpdate),R.push(k.premultiplyAlpha),R.push(k.flipY),R.push(k.unpackAlignment),R.push(k.colorSpace),R.join()}function he(k,R){let q=i.get(k);if(k.isVideoTexture&&Et(k),k.isRenderTargetTexture===!1&&k.isExternalTexture!==!0&&k.version>0&&q.__version!==k.version){let ce=k.image;if(ce===null)Ke("WebGLRenderer: Texture marked for update but no image data found.");else if(ce.complete===!1)Ke("WebGLRenderer: Texture marked for update but image is incomplete");else{Bt(q,k,R);return}}else k.isExternalTexture&&(q.__webglTexture=k.sourceTexture?k.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+R)}function xe(k,R){let q=i.get(k);if(k.isRenderTargetTexture===!1&&k.version>0&&q.__version!==k.version){Bt(q,k,R);return}else k.isExternalTexture&&(q.__webglTexture=k.sourceTexture?k.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+R)}function be(k,R){let q=i.get(k);if(k.isRenderTargetTexture===!1&&k.version>0&&q.__version!==k.version){Bt(q,k,R);return}t.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+R)}function Se(k,R){let q=i.get(k);if(k.version>0&&q.__version!==k.version){en(q,k,R);return}t.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+R)}let $e={[ac]:n.REPEAT,[es]:n.CLAMP_TO_EDGE,[lc]:n.MIRRORED_REPEAT},ot={[Nn]:n.NEAREST,[Ag]:n.NEAREST_MIPMAP_NEAREST,[Ha]:n.NEAREST_MIPMAP_LINEAR,[Zn]:n.LINEAR,[kc]:n.LINEAR_MIPMAP_NEAREST,[Cs]:n.LINEAR_MIPMAP_LINEAR},We={[Rg]:n.NEVER,[Zd]:n.ALWAYS,[Pg]:n.LESS,[qd]:n.LEQUAL,[Ig]:n.EQUAL,[Yd]:n.GEQUAL,[Lg]:n.GREATER,[Ng]:n.NOTEQUAL};function lt(k,R){if(R.type===Mi&&e.has("OES_texture_float_linear")===!1&&(R.magFilter===Zn||R.magFilter===kc||R.magFilter===Ha||R.magFilter===Cs||R.minFilter===Zn||R.minFilter===kc||R.minFilter===Ha||R.minFilter===Cs)&&Ke("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(k,n.TEXTURE_WRAP_S,$e[R.wrapS]),n.texParameteri(k,n.TEXTURE_WRAP_T,$e[R.wrapT]),(k===n.TEXTURE_3D||k===n.TEXTURE_2D_ARRAY)&&n.texParameteri(k,n.TEXTURE_WRAP_R,$e[R.wrapR]),n.texParameteri(k,n.TEXTURE_MAG_FILTER,ot[R.magFilter]),n.texParameteri(k,n.TEXTURE_MIN_FILTER,ot[R.minFilter]),R.compareFunction&&(n.texParameteri(k,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(k,n.TEXTURE_COMPARE_FUNC,We[R.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(R.magFilter===Nn||R.minFilter!==Ha&&R.minFilter!==Cs||R.type===Mi&&e.has("OES_texture_float_linear")===!1)return;if(R.anisotropy>1||i.get(R).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");n.texParameterf(k,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(R.anisotropy,s.getMaxAnisotropy())),i.get(R).__currentAnisotropy=R.anisotropy}}}function ct(k,R){let q=!1;k.__webglInit===void 0&&(k.__webglInit=!0,R.addEventListener("dispose",C),T(R));let ce=R.source,ae=f.get(ce);ae===void 0&&(ae={},f.set(ce,ae));let ve=ee(R);if(ve!==k.__cacheKey){ae[ve]===void 0&&(ae[ve]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),ae[ve].usedTimes++;let Me=ae[k.__cacheKey];Me!==void 0&&(ae[k.__cacheKey].usedTimes--,Me.usedTimes===0&&H(R)),k.__cacheKey=ve,k.__webglTexture=ae[ve].texture}return q}function et(k,R,q){return Math.floor(Math.floor(k/q)/R)}function $t(k,R,q,ce){let ve=k.updateRanges;if(ve.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,R.width,R.height,q,ce,R.data);else{ve.sort((V,oe)=>V.start-oe.start);let Me=0;for(let V=1;V<ve.length;V++){let oe=ve[Me],ie=ve[V],Te=oe.start+oe.count,_e=et(ie.start,R.width,4),Ee=et(oe.start,R.width,4);ie.start<=Te+1&&_e===Ee&&et(ie.start+ie.count-1,R.width,4)===_e?oe.count=Math.max(oe.count,ie.start+ie.count-oe.start):(++Me,ve[Me]=ie)}ve.length=Me+1;let ne=t.getParameter(n.UNPACK_ROW_LENGTH),re=t.getParameter(n.UNPACK_SKIP_PIXELS),ge=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,R.width);for(let V=0,oe=ve.length;V<oe;V++){let ie=ve[V],Te=Math.floor(ie.start/4),_e=Math.ceil(ie.count/4),Ee=Te%R.width,Xe=Math.floor(Te/R.width),nt=_e,ue=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Ee),t.pixelStorei(n.UNPACK_SKIP_ROWS,Xe),t.texSubImage2D(n.TEXTURE_2D,0,Ee,Xe,nt,ue,q,ce,R.data)}k.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,ne),t.pixelStorei(n.UNPACK_SKIP_PIXELS,re),t.pixelStorei(n.UNPACK_SKIP_ROWS,ge)}}function Bt(k,R,q){let ce=n.TEXTURE_2D;(R.isDataArrayTexture||R.isCompressedArrayTexture)&&(ce=n.TEXTURE_2D_ARRAY),R.isData3DTexture&&(ce=n.TEXTURE_3D);let ae=ct(k,R),ve=R.source;t.bindTexture(ce,k.__webglTexture,n.TEXTURE0+q);let Me=i.get(ve);if(ve.version!==Me.__version||ae===!0){if(t.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&R.image instanceof ImageBitmap)===!1){let ue=St.getPrimaries(St.workingColorSpace),Ve=R.colorSpace===Ps?null:St.getPrimaries(R.colorSpace),it=R.colorSpace===Ps||ue===Ve?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,R.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,it)}t.pixelStorei(n.UNPACK_ALIGNMENT,R.unpackAlignment);let re=_(R.image,!1,s.maxTextureSize);re=ze(R,re);let ge=r.convert(R.format,R.colorSpace),V=r.convert(R.type),oe=M(R.internalFormat,ge,V,R.normalized,R.colorSpace,R.isVideoTexture);lt(ce,R);let ie,Te=R.mipmaps,_e=R.isVideoTexture!==!0,Ee=Me.__version===void 0||ae===!0,Xe=ve.dataReady,nt=b(R,re);if(R.isDepthTexture)oe=y(R.format===Rs,R.type),Ee&&(_e?t.texStorage2D(n.TEXTURE_2D,1,oe,re.width,re.height):t.texImage2D(n.TEXTURE_2D,0,oe,re.width,re.height,0,ge,V,null));else if(R.isDataTexture)if(Te.length>0){_e&&Ee&&t.texStorage2D(n.TEXTURE_2D,nt,oe,Te[0].width,Te[0].height);for(let ue=0,Ve=Te.length;ue<Ve;ue++)ie=Te[ue],_e?Xe&&t.texSubImage2D(n.TEXTURE_2D,ue,0,0,ie.width,ie.height,ge,V,ie.data):t.texImage2D(n.TEXTURE_2D,ue,oe,ie.width,ie.height,0,ge,V,ie.data);R.generateMipmaps=!1}else _e?(Ee&&t.texStorage2D(n.TEXTURE_2D,nt,oe,re.width,re.height),Xe&&$t(R,re,ge,V)):t.texImage2D(n.TEXTURE_2D,0,oe,re.width,re.height,0,ge,V,re.data);else if(R.isCompressedTexture)if(R.isCompressedArrayTexture){_e&&Ee&&t.texStorage3D(n.TEXTURE_2D_ARRAY,nt,oe,Te[0].width,Te[0].height,re.depth);for(let ue=0,Ve=Te.length;ue<Ve;ue++)if(ie=Te[ue],R.format!==Ui)if(ge!==null)if(_e){if(Xe)if(R.layerUpdates.size>0){let it=of(ie.width,ie.height,R.format,R.type);for(let Pe of R.layerUpdates){let ht=ie.data.subarray(Pe*it/ie.data.BYTES_PER_ELEMENT,(Pe+1)*it/ie.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ue,0,0,Pe,ie.width,ie.height,1,ge,ht)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ue,0,0,0,ie.width,ie.height,re.depth,ge,ie.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ue,oe,ie.width,ie.height,re.depth,0,ie.data,0,0);else Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _e?Xe&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ue,0,0,0,ie.width,ie.height,re.depth,ge,V,ie.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ue,oe,ie.width,ie.height,re.depth,0,ge,V,ie.data);R.layerUpdates.size>0&&R.clearLayerUpdates()}else{_e&&Ee&&t.texStorage2D(n.TEXTURE_2D,nt,oe,Te[0].width,Te[0].height);for(let ue=0,Ve=Te.length;ue<Ve;ue++)ie=Te[ue],R.format!==Ui?ge!==null?_e?Xe&&t.compressedTexSubImage2D(n.TEXTURE_2D,ue,0,0,ie.width,ie.height,ge,ie.data):t.compressedTexImage2D(n.TEXTURE_2D,ue,oe,ie.width,ie.height,0,ie.data):Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_e?Xe&&t.texSubImage2D(n.TEXTURE_2D,ue,0,0,ie.width,ie.height,ge,V,ie.data):t.texImage2D(n.TEXTURE_2D,ue,oe,ie.width,ie.height,0,ge,V,ie.data)}else if(R.isDataArrayTexture)if(_e){if(Ee&&t.texStorage3D(n.TEXTURE_2D_ARRAY,nt,oe,re.width,re.height,re.depth),Xe)if(R.layerUpdates.size>0){let ue=of(re.width,re.height,R.format,R.type);for(let Ve of R.layerUpdates){let it=re.data.subarray(Ve*ue/re.data.BYTES_PER_ELEMENT,(Ve+1)*ue/re.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Ve,re.width,re.height,1,ge,V,it)}R.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,re.width,re.height,re.depth,ge,V,re.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,oe,re.width,re.height,re.depth,0,ge,V,re.data);else if(R.isData3DTexture)_e?(Ee&&t.texStorage3D(n.TEXTURE_3D,nt,oe,re.width,re.height,re.depth),Xe&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,re.width,re.height,re.depth,ge,V,re.data)):t.texImage3D(n.TEXTURE_3D,0,oe,re.width,re.height,re.depth,0,ge,V,re.data);else if(R.isFramebufferTexture){if(Ee)if(_e)t.texStorage2D(n.TEXTURE_2D,nt,oe,re.width,re.height);else{let ue=re.width,Ve=re.height;for(let it=0;it<nt;it++)t.texImage2D(n.TEXTURE_2D,it,oe,ue,Ve,0,ge,V,null),ue>>=1,Ve>>=1}}else if(R.isHTMLTexture){if("texElementImage2D"in n){let ue=n.canvas;if(ue.hasAttribute("layoutsubtree")||ue.setAttribute("layoutsubtree","true"),re.parentNode!==ue){ue.appendChild(re),u.add(R),ue.onpaint=Ve=>{let it=Ve.changedElements;for(let Pe of u)it.includes(Pe.image)&&(Pe.needsUpdate=!0)},ue.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,re);else{let it=n.RGBA,Pe=n.RGBA,ht=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,it,Pe,ht,re)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Te.length>0){if(_e&&Ee){let ue=Ye(Te[0]);t.texStorage2D(n.TEXTURE_2D,nt,oe,ue.width,ue.height)}for(let ue=0,Ve=Te.length;ue<Ve;ue++)ie=Te[ue],_e?Xe&&t.texSubImage2D(n.TEXTURE_2D,ue,0,0,ge,V,ie):t.texImage2D(n.TEXTURE_2D,ue,oe,ge,V,ie);R.generateMipmaps=!1}else if(_e){if(Ee){let ue=Ye(re);t.texStorage2D(n.TEXTURE_2D,nt,oe,ue.width,ue.height)}Xe&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,ge,V,re)}else t.texImage2D(n.TEXTURE_2D,0,oe,ge,V,re);w(R)&&R.mipmapsAutoUpdate===!0&&S(ce),Me.__version=ve.version,R.onUpdate&&R.onUpdate(R)}k.__version=R.version}function en(k,R,q){if(R.image.length!==6)return;let ce=ct(k,R),ae=R.source;t.bindTexture(n.TEXTURE_CUBE_MAP,k.__webglTexture,n.TEXTURE0+q);let ve=i.get(ae);if(ae.version!==ve.__version||ce===!0){t.activeTexture(n.TEXTURE0+q);let Me=St.getPrimaries(St.workingColorSpace),ne=R.colorSpace===Ps?null:St.getPrimaries(R.colorSpace),re=R.colorSpace===Ps||Me===ne?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,R.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,R.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,re);let ge=R.isCompressedTexture||R.image[0].isCompressedTexture,V=R.image[0]&&R.image[0].isDataTexture,oe=[];for(let Pe=0;Pe<6;Pe++)!ge&&!V?oe[Pe]=_(R.image[Pe],!0,s.maxCubemapSize):oe[Pe]=V?R.image[Pe].image:R.image[Pe],oe[Pe]=ze(R,oe[Pe]);let ie=oe[0],Te=r.convert(R.format,R.colorSpace),_e=r.convert(R.type),Ee=M(R.internalFormat,Te,_e,R.normalized,R.colorSpace),Xe=R.isVideoTexture!==!0,nt=ve.__version===void 0||ce===!0,ue=ae.dataReady,Ve=b(R,ie);lt(n.TEXTURE_CUBE_MAP,R);let it;if(R.isDepthTexture){if(Ee=y(R.format===Rs,R.type),nt)if(Xe)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Ee,ie.width,ie.height);else for(let Pe=0;Pe<6;Pe++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Ee,ie.width,ie.height,0,Te,_e,null)}else if(ge){Xe&&nt&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Ve,Ee,ie.width,ie.height);for(let Pe=0;Pe<6;Pe++){it=oe[Pe].mipmaps;for(let ht=0;ht<it.length;ht++){let Xt=it[ht];R.format!==Ui?Te!==null?Xe?ue&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht,0,0,Xt.width,Xt.height,Te,Xt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht,Ee,Xt.width,Xt.height,0,Xt.data):Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Xe?ue&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht,0,0,Xt.width,Xt.height,Te,_e,Xt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht,Ee,Xt.width,Xt.height,0,Te,_e,Xt.data)}}}else{if(it=R.mipmaps,Xe&&nt){it.length>0&&Ve++;let Pe=Ye(oe[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Ve,Ee,Pe.width,Pe.height)}for(let Pe=0;Pe<6;Pe++)if(V){Xe?ue&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,oe[Pe].width,oe[Pe].height,Te,_e,oe[Pe].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Ee,oe[Pe].width,oe[Pe].height,0,Te,_e,oe[Pe].data);for(let ht=0;ht<it.length;ht++){let Gn=it[ht].image[Pe].image;Xe?ue&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht+1,0,0,Gn.width,Gn.height,Te,_e,Gn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht+1,Ee,Gn.width,Gn.height,0,Te,_e,Gn.data)}}else{Xe?ue&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,Te,_e,oe[Pe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Ee,Te,_e,oe[Pe]);for(let ht=0;ht<it.length;ht++){let Xt=it[ht];Xe?ue&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht+1,0,0,Te,_e,Xt.image[Pe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht+1,Ee,Te,_e,Xt.image[Pe])}}}w(R)&&R.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),ve.__version=ae.version,R.onUpdate&&R.onUpdate(R)}k.__version=R.version}function At(k,R,q,ce,ae,ve){let Me=r.convert(q.format,q.colorSpace),ne=r.convert(q.type),re=M(q.internalFormat,Me,ne,q.normalized,q.colorSpace),ge=i.get(R),V=i.get(q);if(V.__renderTarget=R,!ge.__hasExternalTextures){let oe=Math.max(1,R.width>>ve),ie=Math.max(1,R.height>>ve);ae===n.TEXTURE_3D||ae===n.TEXTURE_2D_ARRAY?t.texImage3D(ae,ve,re,oe,ie,R.depth,0,Me,ne,null):t.texImage2D(ae,ve,re,oe,ie,0,Me,ne,null)}t.bindFramebuffer(n.FRAMEBUFFER,k),ye(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ce,ae,V.__webglTexture,0,Qe(R)):(ae===n.TEXTURE_2D||ae>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ae<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ce,ae,V.__webglTexture,ve),t.bindFramebuffer(n.FRAMEBUFFER,null)}function dn(k,R,q){if(n.bindRenderbuffer(n.RENDERBUFFER,k),R.depthBuffer){let ce=R.depthTexture,ae=ce&&ce.isDepthTexture?ce.type:null,ve=y(R.stencilBuffer,ae),Me=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;ye(R)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,Qe(R),ve,R.width,R.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,Qe(R),ve,R.width,R.height):n.renderbufferStorage(n.RENDERBUFFER,ve,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,Me,n.RENDERBUFFER,k)}else{let ce=R.textures;for(let ae=0;ae<ce.length;ae++){let ve=ce[ae],Me=r.convert(ve.format,ve.colorSpace),ne=r.convert(ve.type),re=M(ve.internalFormat,Me,ne,ve.normalized,ve.colorSpace);ye(R)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,Qe(R),re,R.width,R.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,Qe(R),re,R.width,R.height):n.renderbufferStorage(n.RENDERBUFFER,re,R.width,R.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function vt(k,R,q){let ce=R.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,k),!(R.depthTexture&&R.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ae=i.get(R.depthTexture);ae.__renderTarget=R;let ve=ce?R.depthTexture.image[0]:R.depthTexture.image;(!ae.__webglTexture||ve.width!==R.width||ve.height!==R.height)&&(ve.width=R.width,ve.height=R.height,R.depthTexture.needsUpdate=!0),ce?Se(R.depthTexture,0):he(R.depthTexture,0);let Me=ae.__webglTexture,ne=Qe(R),re=ce?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,ge=R.depthTexture.format===Rs?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(R.depthTexture.format===bs)ye(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ge,re,Me,0,ne):n.framebufferTexture2D(n.FRAMEBUFFER,ge,re,Me,0);else if(R.depthTexture.format===Rs)ye(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ge,re,Me,0,ne):n.framebufferTexture2D(n.FRAMEBUFFER,ge,re,Me,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function we(k){let R=i.get(k),q=k.isWebGLCubeRenderTarget===!0;if(R.__boundDepthTexture!==k.depthTexture){let ce=k.depthTexture;if(R.__depthDisposeCallback&&R.__depthDisposeCallback(),ce){let ae=()=>{delete R.__boundDepthTexture,delete R.__depthDisposeCallback,ce.removeEventListener("dispose",ae)};ce.addEventListener("dispose",ae),R.__depthDisposeCallback=ae}R.__boundDepthTexture=ce}if(k.depthTexture&&!R.__autoAllocateDepthBuffer)if(q)for(let ce=0;ce<6;ce++)vt(R.__webglFramebuffer[ce],k,ce);else k.texture.mipmaps.length>0?vt(R.__webglFramebuffer[0],k,0):vt(R.__webglFramebuffer,k,0);else if(q){R.__webglDepthbuffer=[];for(let ce=0;ce<6;ce++)if(t.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer[ce]),R.__webglDepthbuffer[ce]===void 0)R.__webglDepthbuffer[ce]=n.createRenderbuffer(),dn(R.__webglDepthbuffer[ce],k,!1);else{let ae=k.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=R.__webglDepthbuffer[ce];n.bindRenderbuffer(n.RENDERBUFFER,ve),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,ve)}}else if(k.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer),R.__webglDepthbuffer===void 0)R.__webglDepthbuffer=n.createRenderbuffer(),dn(R.__webglDepthbuffer,k,!1);else{let ae=k.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=R.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,ve),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,ve)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function Fe(k,R,q){let ce=i.get(k);R!==void 0&&At(ce.__webglFramebuffer,k,k.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&we(k)}function Ze(k){let R=k.texture,q=i.get(k),ce=i.get(R);k.addEventListener("dispose",D),T(k);let ae=k.textures,ve=k.isWebGLCubeRenderTarget===!0,Me=ae.length>1;if(Me||(ce.__webglTexture===void 0&&(ce.__webglTexture=n.createTexture()),ce.__version=R.version,o.memory.textures++),ve){q.__webglFramebuffer=[];for(let ne=0;ne<6;ne++)if(R.mipmaps.length>0){q.__webglFramebuffer[ne]=[];for(let re=0;re<R.mipmaps.length;re++)q.__webglFramebuffer[ne][re]=n.createFramebuffer()}else q.__webglFramebuffer[ne]=n.createFramebuffer()}else{if(R.mipmaps.length>0){q.__webglFramebuffer=[];for(let ne=0;ne<R.mipmaps.length;ne++)q.__webglFramebuffer[ne]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(Me)for(let ne=0,re=ae.length;ne<re;ne++){let ge=i.get(ae[ne]);ge.__webglTexture===void 0&&(ge.__webglTexture=n.createTexture(),o.memory.textures++)}if(k.samples>0&&ye(k)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let ne=0;ne<ae.length;ne++){let re=ae[ne];q.__webglColorRenderbuffer[ne]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[ne]);let ge=r.convert(re.format,re.colorSpace),V=r.convert(re.type),oe=M(re.internalFormat,ge,V,re.normalized,re.colorSpace,k.isXRRenderTarget===!0),ie=Qe(k);n.renderbufferStorageMultisample(n.RENDERBUFFER,ie,oe,k.width,k.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ne,n.RENDERBUFFER,q.__webglColorRenderbuffer[ne])}n.bindRenderbuffer(n.RENDERBUFFER,null),k.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),dn(q.__webglDepthRenderbuffer,k,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(ve){t.bindTexture(n.TEXTURE_CUBE_MAP,ce.__webglTexture),lt(n.TEXTURE_CUBE_MAP,R);for(let ne=0;ne<6;ne++)if(R.mipmaps.length>0)for(let re=0;re<R.mipmaps.length;re++)At(q.__webglFramebuffer[ne][re],k,R,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ne,re);else At(q.__webglFramebuffer[ne],k,R,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ne,0);w(R)?S(n.TEXTURE_CUBE_MAP):R.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),t.unbindTexture()}else if(Me){for(let ne=0,re=ae.length;ne<re;ne++){let ge=ae[ne],V=i.get(ge),oe=n.TEXTURE_2D;(k.isWebGL3DRenderTarget||k.isWebGLArrayRenderTarget)&&(oe=k.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(oe,V.__webglTexture),lt(oe,ge),At(q.__webglFramebuffer,k,ge,n.COLOR_ATTACHMENT0+ne,oe,0),w(ge)&&S(oe)}t.unbindTexture()}else{let ne=n.TEXTURE_2D;if((k.isWebGL3DRenderTarget||k.isWebGLArrayRenderTarget)&&(ne=k.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ne,ce.__webglTexture),lt(ne,R),R.mipmaps.length>0)for(let re=0;re<R.mipmaps.length;re++)At(q.__webglFramebuffer[re],k,R,n.COLOR_ATTACHMENT0,ne,re);else At(q.__webglFramebuffer,k,R,n.COLOR_ATTACHMENT0,ne,0);w(R)?S(ne):R.mipmaps.length>0&&n.texParameteri(ne,n.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),t.unbindTexture()}k.depthBuffer&&we(k)}function B(k){let R=k.textures;for(let q=0,ce=R.length;q<ce;q++){let ae=R[q];if(w(ae)&&ae.mipmapsAutoUpdate===!0){let ve=A(k),Me=i.get(ae).__webglTexture;t.bindTexture(ve,Me),S(ve),t.unbindTexture()}}}let de=[];function ke(k){if(k.samples>0){if(ye(k)===!1){let R=k.textures,q=k.width,ce=k.height,ae=n.COLOR_BUFFER_BIT,ve=k.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Me=i.get(k),ne=R.length>1;if(ne)for(let ge=0;ge<R.length;ge++)t.bindFramebuffer(n.FRAMEBUFFER,Me.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,Me.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,Me.__webglMultisampledFramebuffer),k.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Me.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Me.__webglFramebuffer);for(let ge=0;ge<R.length;ge++){if(k.resolveDepthBuffer&&(k.depthBuffer&&(ae|=n.DEPTH_BUFFER_BIT),k.stencilBuffer&&k.resolveStencilBuffer&&(ae|=n.STENCIL_BUFFER_BIT)),ne){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,Me.__webglColorRenderbuffer[ge]);let V=i.get(R[ge]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,V,0)}n.blitFramebuffer(0,0,q,ce,0,0,q,ce,ae,n.NEAREST),l===!0&&(de.length=0,de.push(n.COLOR_ATTACHMENT0+ge),k.depthBuffer&&k.storeMultisampledDepthBuffer===!1&&de.push(ve),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,de))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ne)for(let ge=0;ge<R.length;ge++){t.bindFramebuffer(n.FRAMEBUFFER,Me.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.RENDERBUFFER,Me.__webglColorRenderbuffer[ge]);let V=i.get(R[ge]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,Me.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.TEXTURE_2D,V,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Me.__webglMultisampledFramebuffer)}else if(k.depthBuffer&&k.storeMultisampledDepthBuffer===!1&&l){let R=k.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[R])}}}function Qe(k){return Math.min(s.maxSamples,k.samples)}function ye(k){let R=i.get(k);return k.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&R.__useRenderToTexture!==!1}function Et(k){let R=o.render.frame;h.get(k)!==R&&(h.set(k,R),k.update())}function ze(k,R){let q=k.colorSpace,ce=k.format,ae=k.type;return k.isCompressedTexture===!0||k.isVideoTexture===!0||q!==Sa&&q!==Ps&&(St.getTransfer(q)===Dt?(ce!==Ui||ae!==ti)&&Ke("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):st("WebGLTextures: Unsupported texture color space:",q)),R}function Ye(k){return typeof HTMLImageElement<"u"&&k instanceof HTMLImageElement?(c.width=k.naturalWidth||k.width,c.height=k.naturalHeight||k.height):typeof VideoFrame<"u"&&k instanceof VideoFrame?(c.width=k.displayWidth,c.height=k.displayHeight):(c.width=k.width,c.height=k.height),c}this.allocateTextureUnit=fe,this.resetTextureUnits=J,this.getTextureUnits=te,this.setTextureUnits=pe,this.setTexture2D=he,this.setTexture2DArray=xe,this.setTexture3D=be,this.setTextureCube=Se,this.rebindTextures=Fe,this.setupRenderTarget=Ze,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=ke,this.setupDepthRenderbuffer=we,this.setupFrameBufferTexture=At,this.useMultisampledRTT=ye,this.dispose=z}function uE(n,e){function t(i,s=Ps){let r,o=St.getTransfer(s);if(i===ti)return n.UNSIGNED_BYTE;if(i===Uc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Fc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Vd)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Gd)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Bd)return n.BYTE;if(i===zd)return n.SHORT;if(i===Io)return n.UNSIGNED_SHORT;if(i===Oc)return n.INT;if(i===ki)return n.UNSIGNED_INT;if(i===Mi)return n.FLOAT;if(i===Oi)return n.HALF_FLOAT;if(i===Hd)return n.ALPHA;if(i===Wd)return n.RGB;if(i===Ui)return n.RGBA;if(i===bs)return n.DEPTH_COMPONENT;if(i===Rs)return n.DEPTH_STENCIL;if(i===Bc)return n.RED;if(i===zc)return n.RED_INTEGER;if(i===ir)return n.RG;if(i===Vc)return n.RG_INTEGER;if(i===Gc)return n.RGBA_INTEGER;if(i===Wa||i===$a||i===Xa||i===qa)if(o===Dt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Wa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===$a)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Xa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===qa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Wa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===$a)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Xa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===qa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Hc||i===Wc||i===$c||i===Xc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Hc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Wc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===$c)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Xc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===qc||i===Yc||i===Zc||i===jc||i===Kc||i===Ya||i===Jc)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===qc||i===Yc)return o===Dt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Zc)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===jc)return r.COMPRESSED_R11_EAC;if(i===Kc)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Ya)return r.COMPRESSED_RG11_EAC;if(i===Jc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Qc||i===eu||i===tu||i===nu||i===iu||i===su||i===ru||i===ou||i===au||i===lu||i===cu||i===uu||i===hu||i===du)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Qc)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===eu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===tu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===nu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===iu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===su)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===ru)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===ou)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===au)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===lu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===cu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===uu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===hu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===du)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===fu||i===pu||i===mu)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===fu)return o===Dt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===pu)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===mu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===gu||i===xu||i===Za||i===_u)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===gu)return r.COMPRESSED_RED_RGTC1_EXT;if(i===xu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Za)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===_u)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Ir?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var hE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,dE=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,mf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new Na(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new ns({vertexShader:hE,fragmentShader:dE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new _n(new Da(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},gf=class extends Di{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,p=null,x=typeof XRWebGLBinding<"u",m=new mf,g={},_=t.getContextAttributes(),w=null,S=null,A=[],M=[],y=new Je,b=null,T=null,P=new Yn;P.viewport=new Gt;let C=new Yn;C.viewport=new Gt;let D=[P,C],U=new Ic,N=null,z=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let he=A[ee];return he===void 0&&(he=new wo,A[ee]=he),he.getTargetRaySpace()},this.getControllerGrip=function(ee){let he=A[ee];return he===void 0&&(he=new wo,A[ee]=he),he.getGripSpace()},this.getHand=function(ee){let he=A[ee];return he===void 0&&(he=new wo,A[ee]=he),he.getHandSpace()};function W(ee){let he=M.indexOf(ee.inputSource);if(he===-1)return;let xe=A[he];xe!==void 0&&(xe.update(ee.inputSource,ee.frame,c||o),xe.dispatchEvent({type:ee.type,data:ee.inputSource}))}function H(){s.removeEventListener("select",W),s.removeEventListener("selectstart",W),s.removeEventListener("selectend",W),s.removeEventListener("squeeze",W),s.removeEventListener("squeezestart",W),s.removeEventListener("squeezeend",W),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",se);for(let ee=0;ee<A.length;ee++){let he=M[ee];he!==null&&(M[ee]=null,A[ee].disconnect(he))}N=null,z=null,m.reset();for(let ee in g)delete g[ee];if(e.setRenderTarget(w),f=null,d=null,u=null,s=null,S=null,fe.stop(),i.isPresenting=!1,e.setPixelRatio(b),e.setSize(y.width,y.height,!1),T!==null){let ee=T.camera;ee.fov=T.fov,ee.zoom=T.zoom,ee.updateProjectionMatrix(),T=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,i.isPresenting===!0&&Ke("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&Ke("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&x&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(w=e.getRenderTarget(),s.addEventListener("select",W),s.addEventListener("selectstart",W),s.addEventListener("selectend",W),s.addEventListener("squeeze",W),s.addEventListener("squeezestart",W),s.addEventListener("squeezeend",W),s.addEventListener("end",H),s.addEventListener("inputsourceschange",se),_.xrCompatible!==!0&&await t.makeXRCompatible(),b=e.getPixelRatio(),e.getSize(y),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let xe=null,be=null,Se=null;_.depth&&(Se=_.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,xe=_.stencil?Rs:bs,be=_.stencil?Ir:ki);let $e={colorFormat:t.RGBA8,depthFormat:Se,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer($e),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),S=new di(d.textureWidth,d.textureHeight,{format:Ui,type:ti,depthTexture:new Es(d.textureWidth,d.textureHeight,be,void 0,void 0,void 0,void 0,void 0,void 0,xe),stencilBuffer:_.stencil,colorSpace:e.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let xe={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,xe),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),S=new di(f.framebufferWidth,f.framebufferHeight,{format:Ui,type:ti,colorSpace:e.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),fe.setContext(s),fe.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function se(ee){for(let he=0;he<ee.removed.length;he++){let xe=ee.removed[he],be=M.indexOf(xe);be>=0&&(M[be]=null,A[be].disconnect(xe))}for(let he=0;he<ee.added.length;he++){let xe=ee.added[he],be=M.indexOf(xe);if(be===-1){for(let $e=0;$e<A.length;$e++)if($e>=M.length){M.push(xe),be=$e;break}else if(M[$e]===null){M[$e]=xe,be=$e;break}if(be===-1)break}let Se=A[be];Se&&Se.connect(xe)}}function Y(ee,he){he===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(he.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let he=ee.near,xe=ee.far;m.texture!==null&&(m.depthNear>0&&(he=m.depthNear),m.depthFar>0&&(xe=m.depthFar)),U.near=C.near=P.near=he,U.far=C.far=P.far=xe,(N!==U.near||z!==U.far)&&(s.updateRenderState({depthNear:U.near,depthFar:U.far}),N=U.near,z=U.far),U.layers.mask=ee.layers.mask|6,P.layers.mask=U.layers.mask&-5,C.layers.mask=U.layers.mask&-3;let be=ee.parent,Se=U.cameras;Y(U,be);for(let $e=0;$e<Se.length;$e++)Y(Se[$e],be);U.projectionMatrix.copy(P.projectionMatrix),U.projectionMatrixInverse.copy(P.projectionMatrixInverse),T===null&&ee.isPerspectiveCamera&&(T={camera:ee,fov:ee.fov,zoom:ee.zoom}),J(ee,U,be)};function J(ee,he,xe){xe===null?ee.matrix.copy(he.matrixWorld):(ee.matrix.copy(xe.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(he.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(he.projectionMatrix),ee.projectionMatrixInverse.copy(he.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=vo*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return U},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(ee){l=ee,d!==null&&(d.fixedFoveation=ee),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=ee)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(U)},this.getCameraTexture=function(ee){return g[ee]};let te=null;function pe(ee,he){if(h=he.getViewerPose(c||o),p=he,h!==null){let xe=h.views;f!==null&&(e.setRenderTargetFramebuffer(S,f.framebuffer),e.setRenderTarget(S));let be=!1;xe.length!==U.cameras.length&&(U.cameras.length=0,be=!0);for(let We=0;We<xe.length;We++){let lt=xe[We],ct=null;if(f!==null)ct=f.getViewport(lt);else{let $t=u.getViewSubImage(d,lt);ct=$t.viewport,We===0&&(e.setRenderTargetTextures(S,$t.colorTexture,$t.depthStencilTexture),e.setRenderTarget(S))}let et=D[We];et===void 0&&(et=new Yn,et.layers.enable(We),et.viewport=new Gt,D[We]=et),et.matrix.fromArray(lt.transform.matrix),et.matrix.decompose(et.position,et.quaternion,et.scale),et.projectionMatrix.fromArray(lt.projectionMatrix),et.projectionMatrixInverse.copy(et.projectionMatrix).invert(),et.viewport.set(ct.x,ct.y,ct.width,ct.height),We===0&&(U.matrix.copy(et.matrix),U.matrix.decompose(U.position,U.quaternion,U.scale)),be===!0&&U.cameras.push(et)}let Se=s.enabledFeatures;if(Se&&Se.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){u=i.getBinding();let We=u.getDepthInformation(xe[0]);We&&We.isValid&&We.texture&&m.init(We,s.renderState)}if(Se&&Se.includes("camera-access")&&x){e.state.unbindTexture(),u=i.getBinding();for(let We=0;We<xe.length;We++){let lt=xe[We].camera;if(lt){let ct=g[lt];ct||(ct=new Na,g[lt]=ct);let et=u.getCameraImage(lt);ct.sourceTexture=et}}}}for(let xe=0;xe<A.length;xe++){let be=M[xe],Se=A[xe];be!==null&&Se!==void 0&&Se.update(be,he,c||o)}te&&te(ee,he),he.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:he}),p=null}let fe=new d0;fe.setAnimationLoop(pe),this.setAnimationLoop=function(ee){te=ee},this.dispose=function(){}}},fE=new dt,S0=new rt;S0.set(-1,0,0,0,1,0,0,0,1);function pE(n,e){function t(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function i(m,g){g.color.getRGB(m.fogColor.value,nf(n)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,_,w,S){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),u(m,g)):g.isMeshPhongMaterial?(r(m,g),h(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),d(m,g),g.isMeshPhysicalMaterial&&f(m,g,S)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),x(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,_,w):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,t(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===jn&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,t(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===jn&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,t(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,t(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let _=e.get(g),w=_.envMap,S=_.envMapRotation;w&&(m.envMap.value=w,m.envMapRotation.value.setFromMatrix4(fE.makeRotationFromEuler(S)).transpose(),w.isCubeTexture&&w.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(S0),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,_,w){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*_,m.scale.value=w*.5,g.map&&(m.map.value=g.map,t(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function h(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function u(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function d(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,_){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===jn&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=_.texture,m.transmissionSamplerSize.value.set(_.width,_.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function x(m,g){let _=e.get(g).light;m.referencePosition.value.setFromMatrixPosition(_.matrixWorld),m.nearDistance.value=_.shadow.camera.near,m.farDistance.value=_.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function mE(n,e,t,i){let s={},r={};function o(_,w){let S=w.program;i.uniformBlockBinding(_,S,s[_.id])}function a(_,w){let S=s[_.id];S===void 0&&(p(_),S=l(_),s[_.id]=S,_.addEventListener("dispose",m));let A=w.program;i.updateUBOMapping(_,A);let M=e.render.frame;r[_.id]!==M&&(c(_),r[_.id]=M)}function l(_){let w=n.createBuffer(),S=_.__size,A=_.usage;return n.bindBuffer(n.UNIFORM_BUFFER,w),n.bufferData(n.UNIFORM_BUFFER,S,A),n.bindBuffer(n.UNIFORM_BUFFER,null),w}function c(_){let w=s[_.id],S=_.uniforms,A=_.__cache;n.bindBuffer(n.UNIFORM_BUFFER,w);for(let M=0,y=S.length;M<y;M++){let b=S[M];if(Array.isArray(b))for(let T=0,P=b.length;T<P;T++)h(b[T],M,T,A);else h(b,M,0,A)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(_,w,S,A){if(d(_,w,S,A)===!0){let M=_.__offset,y=_.value;if(Array.isArray(y)){let b=0;for(let T=0;T<y.length;T++){let P=y[T],C=x(P,!0);u(P,_.__data,b),b+=C.storage/Float32Array.BYTES_PER_ELEMENT}}else u(y,_.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,M,_.__data)}}function u(_,w,S){typeof _=="number"||typeof _=="boolean"?w[S]=_:_.isMatrix3?(w[S]=_.elements[0],w[S+1]=_.elements[1],w[S+2]=_.elements[2],w[S+3]=0,w[S+4]=_.elements[3],w[S+5]=_.elements[4],w[S+6]=_.elements[5],w[S+7]=0,w[S+8]=_.elements[6],w[S+9]=_.elements[7],w[S+10]=_.elements[8],w[S+11]=0):ArrayBuffer.isView(_)?w.set(_.subarray(0,w.length-S),S):_.toArray(w,S)}function d(_,w,S,A){let M=_.value,y=w+"_"+S;if(Array.isArray(M)){A[y]===void 0&&(A[y]=[]);let b=A[y],T=!1;for(let P=0;P<M.length;P++)f(M[P],b,P)===!0&&(T=!0);return T}return f(M,A,y)}function f(_,w,S){if(w[S]===void 0)return typeof _=="number"||typeof _=="boolean"?w[S]=_:ArrayBuffer.isView(_)?w[S]=_.slice():w[S]=_.clone(),!0;{let A=w[S];if(typeof _=="number"||typeof _=="boolean"){if(A!==_)return w[S]=_,!0}else{if(ArrayBuffer.isView(_))return!0;if(A.equals(_)===!1)return A.copy(_),!0}}return!1}function p(_){let w=_.uniforms,S=0,A=16;for(let y=0,b=w.length;y<b;y++){let T=Array.isArray(w[y])?w[y]:[w[y]];for(let P=0,C=T.length;P<C;P++){let D=T[P],U=Array.isArray(D.value)?D.value:[D.value],N=Array.isArray(w[y])||Array.isArray(D.value),z=S;for(let H=0,se=U.length;H<se;H++){let Y=U[H],J=x(Y,N),te=S%A,pe=te%J.boundary,fe=te+pe;S+=pe,fe!==0&&A-fe<J.storage&&(S+=A-fe),H===0&&(z=S),S+=J.storage}let W=D.type==="int"?Int32Array:D.type==="uint"?Uint32Array:Float32Array;D.__data=new W((S-z)/Float32Array.BYTES_PER_ELEMENT),D.__offset=z}}let M=S%A;return M>0&&(S+=A-M),_.__size=S,_.__cache={},this}function x(_,w){let S={boundary:0,storage:0};return typeof _=="number"||typeof _=="boolean"?(S.boundary=4,S.storage=4):_.isVector2?(S.boundary=8,S.storage=8):_.isVector3||_.isColor?(S.boundary=16,S.storage=12):_.isVector4?(S.boundary=16,S.storage=16):_.isMatrix3?(S.boundary=16,S.storage=48):_.isMatrix4?(S.boundary=16,S.storage=64):_.isTexture?Ke("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(_)?(S.boundary=16,S.storage=_.byteLength):Ke("WebGLRenderer: Unsupported uniform value type.",_),w===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function m(_){let w=_.target;w.removeEventListener("dispose",m),n.deleteBuffer(s[w.id]),delete s[w.id],delete r[w.id]}function g(){for(let _ in s)n.deleteBuffer(s[_]);s={},r={}}return{bind:o,update:a,dispose:g}}var gE=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ss=null;function xE(){return ss===null&&(ss=new Ra(gE,16,16,ir,Oi),ss.name="DFG_LUT",ss.minFilter=Zn,ss.magFilter=Zn,ss.wrapS=es,ss.wrapT=es,ss.generateMipmaps=!1,ss.needsUpdate=!0),ss}var wu=class{constructor(e={}){let{canvas:t=kg(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=ti}=e;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let x=f,m=new Set([Gc,Vc,zc]),g=new Set([ti,ki,Io,Ir,Uc,Fc]),_=new Uint32Array(4),w=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},A=null,M=null,y=[],b=[],T=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=is,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,C=!1,D=null,U=null,N=null,z=null;this._outputColorSpace=ci;let W=0,H=0,se=null,Y=-1,J=null,te=new Gt,pe=new Gt,fe=null,ee=new je(0),he=0,xe=t.width,be=t.height,Se=1,$e=null,ot=null,We=new Gt(0,0,xe,be),lt=new Gt(0,0,xe,be),ct=!1,et=new Zs,$t=new fc,Bt=!1,en=!1,At=new dt,dn=new G,vt=new Gt,we={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Fe=!1;function Ze(){return se===null?Se:1}let B=i;function de(L,$){return t.getContext(L,$)}let ke,Qe,ye,Et,ze,Ye,k,R,q,ce,ae,ve,Me,ne,re,ge,V,oe,ie,Te,_e,Ee,Xe;try{let L={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Ve,!1),t.addEventListener("webglcontextrestored",it,!1),t.addEventListener("webglcontextcreationerror",Pe,!1),B===null){let $="webgl2";if(B=de($,L),B===null)throw de($)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}nt()}catch(L){throw t.removeEventListener("webglcontextlost",Ve,!1),t.removeEventListener("webglcontextrestored",it,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),st("WebGLRenderer: "+L.message),L}function nt(){ke=new C1(B),ke.init(),_e=new uE(B,ke),Qe=new x1(B,ke,e,_e),ye=new lE(B,ke),Qe.reversedDepthBuffer&&d&&ye.buffers.depth.setReversed(!0),U=B.createFramebuffer(),N=B.createFramebuffer(),z=B.createFramebuffer(),Et=new I1(B),ze=new YA,Ye=new cE(B,ke,ye,ze,Qe,_e,Et),k=new T1(P),R=new NS(B),Ee=new m1(B,R),q=new R1(B,R,Et,Ee),ce=new N1(B,q,R,Ee,Et),oe=new L1(B,Qe,Ye),re=new _1(ze),ae=new qA(P,k,ke,Qe,Ee,re),ve=new pE(P,ze),Me=new jA,ne=new nE(ke),V=new p1(P,k,ye,ce,p,l),ge=new aE(P,ce,Qe),Xe=new mE(B,Et,Qe,ye),ie=new g1(B,ke,Et),Te=new P1(B,ke,Et),Et.programs=ae.programs,P.capabilities=Qe,P.extensions=ke,P.properties=ze,P.renderLists=Me,P.shadowMap=ge,P.state=ye,P.info=Et}x!==ti&&(T=new k1(x,t.width,t.height,a,s,r));let ue=new gf(P,B);this.xr=ue,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let L=ke.get("WEBGL_lose_context");L&&L.loseContext()},this.forceContextRestore=function(){let L=ke.get("WEBGL_lose_context");L&&L.restoreContext()},this.getPixelRatio=function(){return Se},this.setPixelRatio=function(L){L!==void 0&&(Se=L,this.setSize(xe,be,!1))},this.getSize=function(L){return L.set(xe,be)},this.setSize=function(L,$,Q=!0){if(ue.isPresenting){Ke("WebGLRenderer: Can't change size while VR device is presenting.");return}xe=L,be=$,t.width=Math.floor(L*Se),t.height=Math.floor($*Se),Q===!0&&(t.style.width=L+"px",t.style.height=$+"px"),T!==null&&T.setSize(t.width,t.height),this.setViewport(0,0,L,$)},this.getDrawingBufferSize=function(L){return L.set(xe*Se,be*Se).floor()},this.setDrawingBufferSize=function(L,$,Q){xe=L,be=$,Se=Q,t.width=Math.floor(L*Q),t.height=Math.floor($*Q),this.setViewport(0,0,L,$)},this.setEffects=function(L){if(x===ti){st("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(L){for(let $=0;$<L.length;$++)if(L[$].isOutputPass===!0){Ke("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}T.setEffects(L||[])},this.getCurrentViewport=function(L){return L.copy(te)},this.getViewport=function(L){return L.copy(We)},this.setViewport=function(L,$,Q,Z){L.isVector4?We.set(L.x,L.y,L.z,L.w):We.set(L,$,Q,Z),ye.viewport(te.copy(We).multiplyScalar(Ze()).round())},this.getScissor=function(L){return L.copy(lt)},this.setScissor=function(L,$,Q,Z){L.isVector4?lt.set(L.x,L.y,L.z,L.w):lt.set(L,$,Q,Z),ye.scissor(pe.copy(lt).multiplyScalar(Ze()).round())},this.getScissorTest=function(){return ct},this.setScissorTest=function(L){ye.setScissorTest(ct=L)},this.setOpaqueSort=function(L){$e=L},this.setTransparentSort=function(L){ot=L},this.getClearColor=function(L){return L.copy(V.getClearColor())},this.setClearColor=function(){V.setClearColor(...arguments)},this.getClearAlpha=function(){return V.getClearAlpha()},this.setClearAlpha=function(){V.setClearAlpha(...arguments)},this.clear=function(L=!0,$=!0,Q=!0){let Z=0;if(L){let j=!1;if(se!==null){let Ce=se.texture.format;j=m.has(Ce)}if(j){let Ce=se.texture.type,Ie=g.has(Ce),Re=V.getClearColor(),Le=V.getClearAlpha(),He=Re.r,at=Re.g,mt=Re.b;Ie?(_[0]=He,_[1]=at,_[2]=mt,_[3]=Le,B.clearBufferuiv(B.COLOR,0,_)):(w[0]=He,w[1]=at,w[2]=mt,w[3]=Le,B.clearBufferiv(B.COLOR,0,w))}else Z|=B.COLOR_BUFFER_BIT}$&&(Z|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(Z|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Z!==0&&B.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(L){L.setRenderer(this),D=L},this.dispose=function(){t.removeEventListener("webglcontextlost",Ve,!1),t.removeEventListener("webglcontextrestored",it,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),V.dispose(),Me.dispose(),ne.dispose(),Ye.dispose(),ze.dispose(),k.dispose(),ce.dispose(),q.dispose(),Ee.dispose(),Xe.dispose(),ae.dispose(),ue.dispose(),ue.removeEventListener("sessionstart",wl),ue.removeEventListener("sessionend",Hi),ls.stop()};function Ve(L){L.preventDefault(),Kd("WebGLRenderer: Context Lost."),C=!0}function it(){Kd("WebGLRenderer: Context Restored."),C=!1;let L=Et.autoReset,$=ge.enabled,Q=ge.autoUpdate,Z=ge.needsUpdate,j=ge.type;nt(),Et.autoReset=L,ge.enabled=$,ge.autoUpdate=Q,ge.needsUpdate=Z,ge.type=j}function Pe(L){st("WebGLRenderer: A WebGL context could not be created. Reason: ",L.statusMessage)}function ht(L){let $=L.target;$.removeEventListener("dispose",ht),Xt($)}function Xt(L){Gn(L),ze.remove(L)}function Gn(L){let $=ze.get(L).programs;$!==void 0&&($.forEach(function(Q){ae.releaseProgram(Q)}),L.isShaderMaterial&&ae.releaseShaderCache(L))}this.renderBufferDirect=function(L,$,Q,Z,j,Ce){$===null&&($=we);let Ie=j.isMesh&&j.matrixWorld.determinantAffine()<0,Re=ra(L,$,Q,Z,j);ye.setMaterial(Z,Ie);let Le=Q.index,He=1;if(Z.wireframe===!0){if(Le=q.getWireframeAttribute(Q),Le===void 0)return;He=2}let at=Q.drawRange,mt=Q.attributes.position,Ge=at.start*He,gt=(at.start+at.count)*He;Ce!==null&&(Ge=Math.max(Ge,Ce.start*He),gt=Math.min(gt,(Ce.start+Ce.count)*He)),Le!==null?(Ge=Math.max(Ge,0),gt=Math.min(gt,Le.count)):mt!=null&&(Ge=Math.max(Ge,0),gt=Math.min(gt,mt.count));let tn=gt-Ge;if(tn<0||tn===1/0)return;Ee.setup(j,Z,Re,Q,Le);let Ot,Ut=ie;if(Le!==null&&(Ot=R.get(Le),Ut=Te,Ut.setIndex(Ot)),j.isMesh)Z.wireframe===!0?(ye.setLineWidth(Z.wireframeLinewidth*Ze()),Ut.setMode(B.LINES)):Ut.setMode(B.TRIANGLES);else if(j.isLine){let vn=Z.linewidth;vn===void 0&&(vn=1),ye.setLineWidth(vn*Ze()),j.isLineSegments?Ut.setMode(B.LINES):j.isLineLoop?Ut.setMode(B.LINE_LOOP):Ut.setMode(B.LINE_STRIP)}else j.isPoints?Ut.setMode(B.POINTS):j.isSprite&&Ut.setMode(B.TRIANGLES);if(j.isBatchedMesh)if(ke.get("WEBGL_multi_draw"))Ut.renderMultiDraw(j._multiDrawStarts,j._multiDrawCounts,j._multiDrawCount);else{let vn=j._multiDrawStarts,Ue=j._multiDrawCounts,fn=j._multiDrawCount,bt=Le?R.get(Le).bytesPerElement:1,us=ze.get(Z).currentProgram.getUniforms();for(let pn=0;pn<fn;pn++)us.setValue(B,"_gl_DrawID",pn),Ut.render(vn[pn]/bt,Ue[pn])}else if(j.isInstancedMesh)Ut.renderInstances(Ge,tn,j.count);else if(Q.isInstancedBufferGeometry){let vn=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Ue=Math.min(Q.instanceCount,vn);Ut.renderInstances(Ge,tn,Ue)}else Ut.render(Ge,tn)};function na(L,$,Q,Z){D!==null&&L.isNodeMaterial&&D.setObject(Z,L),Bt===!0&&re.setState(L,Q,!1),L.transparent===!0&&L.side===zn&&L.forceSinglePass===!1?(L.side=jn,L.needsUpdate=!0,Wi(L,$,Z),L.side=nr,L.needsUpdate=!0,Wi(L,$,Z),L.side=zn):Wi(L,$,Z)}this.compile=function(L,$,Q=null){Q===null&&(Q=L),D!==null&&D.renderStart(L,$,Q),M=ne.get(Q),M.init($),b.push(M),Q.traverseVisible(function(j){j.isLight&&j.layers.test($.layers)&&(M.pushLight(j),j.castShadow&&M.pushShadow(j))}),L!==Q&&L.traverseVisible(function(j){j.isLight&&j.layers.test($.layers)&&(M.pushLight(j),j.castShadow&&M.pushShadow(j))}),M.setupLights(),D!==null&&D.updateLights(M.state.lightsArray),en=this.localClippingEnabled,Bt=re.init(this.clippingPlanes,en),Bt===!0&&re.setGlobalState(this.clippingPlanes,$),D!==null&&ge.render(M.state.shadowsArray,Q,$);let Z=new Set;return L.traverse(function(j){if(!(j.isMesh||j.isPoints||j.isLine||j.isSprite))return;let Ce=j.material;if(Ce)if(Array.isArray(Ce))for(let Ie=0;Ie<Ce.length;Ie++){let Re=Ce[Ie];na(Re,Q,$,j),Z.add(Re)}else na(Ce,Q,$,j),Z.add(Ce)}),M=b.pop(),D!==null&&D.renderEnd(),Z},this.compileAsync=function(L,$,Q=null){let Z=this.compile(L,$,Q);return new Promise(j=>{function Ce(){if(Z.forEach(function(Ie){let Le=ze.get(Ie).currentProgram;(Le===void 0||Le.isReady())&&Z.delete(Ie)}),Z.size===0){j(L);return}setTimeout(Ce,10)}ke.get("KHR_parallel_shader_compile")!==null?Ce():setTimeout(Ce,10)})};let Wr=null;function Uh(L){Wr&&Wr(L)}function wl(){ls.stop()}function Hi(){ls.start()}let ls=new d0;ls.setAnimationLoop(Uh),typeof self<"u"&&ls.setContext(self),this.setAnimationLoop=function(L){Wr=L,ue.setAnimationLoop(L),L===null?ls.stop():ls.start()},ue.addEventListener("sessionstart",wl),ue.addEventListener("sessionend",Hi),this.render=function(L,$){if($!==void 0&&$.isCamera!==!0){st("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(C===!0)return;D!==null&&D.renderStart(L,$);let Q=ue.enabled===!0&&ue.isPresenting===!0,Z=T!==null&&(se===null||Q)&&T.begin(P,se);if(L.matrixWorldAutoUpdate===!0&&L.updateMatrixWorld(),$.parent===null&&$.matrixWorldAutoUpdate===!0&&$.updateMatrixWorld(),ue.enabled===!0&&ue.isPresenting===!0&&(T===null||T.isCompositing()===!1)&&(ue.cameraAutoUpdate===!0&&ue.updateCamera($),$=ue.getCamera()),L.isScene===!0&&L.onBeforeRender(P,L,$,se),M=ne.get(L,b.length),M.init($),M.state.textureUnits=Ye.getTextureUnits(),b.push(M),At.multiplyMatrices($.projectionMatrix,$.matrixWorldInverse),$.isArrayCamera?$t.setFromArrayCamera($):et.setFromProjectionMatrix(At,Si,$.reversedDepth),en=this.localClippingEnabled,Bt=re.init(this.clippingPlanes,en),A=Me.get(L,y.length),A.init(),y.push(A),this.info.render.frame++,ue.enabled===!0&&ue.isPresenting===!0){let Ie=P.xr.getDepthSensingMesh();Ie!==null&&cs(Ie,$,-1/0,P.sortObjects)}cs(L,$,0,P.sortObjects),A.finish(),D!==null&&D.updateLights(M.state.lightsArray),P.sortObjects===!0&&A.sort($e,ot),Fe=ue.enabled===!1||ue.isPresenting===!1||ue.hasDepthSensing()===!1,Fe&&V.addToRenderList(A,L),this.info.autoReset===!0&&this.info.reset(),Bt===!0&&re.beginShadows();let j=M.state.shadowsArray;if(ge.render(j,L,$),Bt===!0&&re.endShadows(),(Z&&T.hasRenderPass())===!1){let Ie=A.opaque,Re=A.transmissive;if(M.setupLights(),$.isArrayCamera){let Le=$.cameras;if(Re.length>0)for(let He=0,at=Le.length;He<at;He++){let mt=Le[He];Ci(Ie,Re,L,mt)}Fe&&V.render(L);for(let He=0,at=Le.length;He<at;He++){let mt=Le[He];ia(A,L,mt,mt.viewport)}}else Re.length>0&&Ci(Ie,Re,L,$),Fe&&V.render(L),ia(A,L,$)}se!==null&&H===0&&(Ye.updateMultisampleRenderTarget(se),Ye.updateRenderTargetMipmap(se)),Z&&T.end(P),L.isScene===!0&&L.onAfterRender(P,L,$),Ee.resetDefaultState(),Y=-1,J=null,b.pop(),b.length>0?(M=b[b.length-1],Ye.setTextureUnits(M.state.textureUnits),Bt===!0&&re.setGlobalState(P.clippingPlanes,M.state.camera)):M=null,y.pop(),y.length>0?A=y[y.length-1]:A=null,D!==null&&D.renderEnd()};function cs(L,$,Q,Z){if(L.visible===!1)return;if(L.layers.test($.layers)){if(L.isGroup)Q=L.renderOrder;else if(L.isLOD)L.autoUpdate===!0&&L.update($);else if(L.isLight)M.pushLight(L),L.castShadow&&M.pushShadow(L);else if(L.isSprite){let Ie=$.isArrayCamera?$t:et;if(!L.frustumCulled||L.intersectsFrustum(Ie)){Z&&vt.setFromMatrixPosition(L.matrixWorld).applyMatrix4(At);let Re=ce.update(L),Le=L.material;Le.visible&&A.push(L,Re,Le,Q,vt.z,null,$)}}else if(L.isMesh||L.isLine||L.isPoints){let Ie=$.isArrayCamera?$t:et;if(!L.frustumCulled||L.intersectsFrustum(Ie)){let Re=ce.update(L),Le=L.material;if(Z&&(L.boundingSphere!==void 0?(L.boundingSphere===null&&L.computeBoundingSphere(),vt.copy(L.boundingSphere.center)):(Re.boundingSphere===null&&Re.computeBoundingSphere(),vt.copy(Re.boundingSphere.center)),vt.applyMatrix4(L.matrixWorld).applyMatrix4(At)),Array.isArray(Le)){let He=Re.groups;for(let at=0,mt=He.length;at<mt;at++){let Ge=He[at],gt=Le[Ge.materialIndex];gt&&gt.visible&&A.push(L,Re,gt,Q,vt.z,Ge,$)}}else Le.visible&&A.push(L,Re,Le,Q,vt.z,null,$)}}}let Ce=L.children;for(let Ie=0,Re=Ce.length;Ie<Re;Ie++)cs(Ce[Ie],$,Q,Z)}function ia(L,$,Q,Z){let{opaque:j,transmissive:Ce,transparent:Ie}=L;M.setupLightsView(Q),Bt===!0&&re.setGlobalState(P.clippingPlanes,Q),Z&&ye.viewport(te.copy(Z)),j.length>0&&nn(j,$,Q),Ce.length>0&&nn(Ce,$,Q),Ie.length>0&&nn(Ie,$,Q),ye.buffers.depth.setTest(!0),ye.buffers.depth.setMask(!0),ye.buffers.color.setMask(!0),ye.setPolygonOffset(!1)}function Ci(L,$,Q,Z){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(M.state.transmissionRenderTarget[Z.id]===void 0){let Ge=ke.has("EXT_color_buffer_half_float")||ke.has("EXT_color_buffer_float");M.state.transmissionRenderTarget[Z.id]=new di(1,1,{generateMipmaps:!0,type:Ge?Oi:ti,minFilter:Cs,samples:Math.max(4,Qe.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:St.workingColorSpace})}let Ce=M.state.transmissionRenderTarget[Z.id],Ie=Z.viewport||te;Ce.setSize(Ie.z*P.transmissionResolutionScale,Ie.w*P.transmissionResolutionScale);let Re=P.getRenderTarget(),Le=P.getActiveCubeFace(),He=P.getActiveMipmapLevel();P.setRenderTarget(Ce),P.getClearColor(ee),he=P.getClearAlpha(),he<1&&P.setClearColor(16777215,.5),P.clear(),Fe&&V.render(Q);let at=P.toneMapping;P.toneMapping=is;let mt=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),M.setupLightsView(Z),Bt===!0&&re.setGlobalState(P.clippingPlanes,Z),nn(L,Q,Z),Ye.updateMultisampleRenderTarget(Ce),Ye.updateRenderTargetMipmap(Ce),ke.has("WEBGL_multisampled_render_to_texture")===!1){let Ge=!1;for(let gt=0,tn=$.length;gt<tn;gt++){let Ot=$[gt],{object:Ut,geometry:vn,material:Ue,group:fn}=Ot;if(Ue.side===zn&&Ut.layers.test(Z.layers)){let bt=Ue.side;Ue.side=jn,Ue.needsUpdate=!0,ln(Ut,Q,Z,vn,Ue,fn),Ue.side=bt,Ue.needsUpdate=!0,Ge=!0}}Ge===!0&&(Ye.updateMultisampleRenderTarget(Ce),Ye.updateRenderTargetMipmap(Ce))}P.setRenderTarget(Re,Le,He),P.setClearColor(ee,he),mt!==void 0&&(Z.viewport=mt),P.toneMapping=at}function nn(L,$,Q){let Z=$.isScene===!0?$.overrideMaterial:null;for(let j=0,Ce=L.length;j<Ce;j++){let Ie=L[j],{object:Re,geometry:Le,group:He}=Ie,at=Ie.material;at.allowOverride===!0&&Z!==null&&(at=Z),Re.layers.test(Q.layers)&&ln(Re,$,Q,Le,at,He)}}function ln(L,$,Q,Z,j,Ce){D!==null&&j.isNodeMaterial&&D.setObject(L,j),L.onBeforeRender(P,$,Q,Z,j,Ce),L.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,L.matrixWorld),L.normalMatrix.getNormalMatrix(L.modelViewMatrix),j.onBeforeRender(P,$,Q,Z,L,Ce),j.transparent===!0&&j.side===zn&&j.forceSinglePass===!1?(j.side=jn,j.needsUpdate=!0,P.renderBufferDirect(Q,$,Z,j,L,Ce),j.side=nr,j.needsUpdate=!0,P.renderBufferDirect(Q,$,Z,j,L,Ce),j.side=zn):P.renderBufferDirect(Q,$,Z,j,L,Ce),L.onAfterRender(P,$,Q,Z,j,Ce)}function cn(L){let $=0;for(let Q of L)Q.texture!==null&&$++;return $}function Wi(L,$,Q){$.isScene!==!0&&($=we);let Z=ze.get(L),j=M.state.lights,Ce=M.state.shadowsArray,Ie=j.state.version,Re=ae.getParameters(L,j.state,Ce,$,Q,M.state.lightProbeGridArray),Le=ae.getProgramCacheKey(Re),He=Z.programs;Z.environment=L.isMeshStandardMaterial||L.isMeshLambertMaterial||L.isMeshPhongMaterial?$.environment:null,Z.fog=$.fog;let at=L.isMeshStandardMaterial||L.isMeshLambertMaterial&&!L.envMap||L.isMeshPhongMaterial&&!L.envMap;Z.envMap=k.get(L.envMap||Z.environment,at),Z.envMapRotation=Z.environment!==null&&L.envMap===null?$.environmentRotation:L.envMapRotation,He===void 0&&(L.addEventListener("dispose",ht),He=new Map,Z.programs=He,Z.programVariants=new Map);let mt=He.get(Le);if(mt!==void 0){if(Z.currentProgram===mt&&Z.lightsStateVersion===Ie)return sa(L,Re),mt}else Re.uniforms=ae.getUniforms(L),D!==null&&L.isNodeMaterial&&D.build(L,Q,Re),L.onBeforeCompile(Re,P),mt=ae.acquireProgram(Re,Le),He.set(Le,mt),Z.uniforms=Re.uniforms;let Ge=Z.uniforms;return(!L.isShaderMaterial&&!L.isRawShaderMaterial||L.clipping===!0)&&(Ge.clippingPlanes=re.uniform),sa(L,Re),Z.needsLights=Us(L),Z.lightsStateVersion=Ie,Z.needsLights&&(Ge.ambientLightColor.value=j.state.ambient,Ge.lightProbe.value=j.state.probe,Ge.sunLights.value=j.state.sun,Ge.sunLightShadows.value=j.state.sunShadow,Ge.directionalLights.value=j.state.directional,Ge.directionalLightShadows.value=j.state.directionalShadow,Ge.spotLights.value=j.state.spot,Ge.spotLightShadows.value=j.state.spotShadow,Ge.rectAreaLights.value=j.state.rectArea,Ge.ltc_1.value=j.state.rectAreaLTC1,Ge.ltc_2.value=j.state.rectAreaLTC2,Ge.pointLights.value=j.state.point,Ge.pointLightShadows.value=j.state.pointShadow,Ge.hemisphereLights.value=j.state.hemi,Ge.sunShadowMatrix.value=j.state.sunShadowMatrix,Ge.sunShadowCascade.value=j.state.sunShadowCascade,Ge.directionalShadowMatrix.value=j.state.directionalShadowMatrix,Ge.spotLightMatrix.value=j.state.spotLightMatrix,Ge.spotLightMap.value=j.state.spotLightMap,Ge.pointShadowMatrix.value=j.state.pointShadowMatrix),Z.numLightProbeGrids=cn(M.state.lightProbeGridArray),Z.currentProgram=mt,Z.uniformsList=null,mt}function ii(L,$,Q,Z,j){let Ce=ze.get(L),Ie=Ce.currentProgram.id+","+Z+","+j,Re=Ce.programVariants.get(Ie);return Re===void 0?(Re=Wi(L,$,Q),Ce.programVariants.set(Ie,Re)):(Ce.currentProgram=Re,Ce.uniformsList=null,Ce.outputColorSpace=Z,Ce.toneMapping=j),Re}function Os(L){if(L.uniformsList===null){let $=L.currentProgram.getUniforms();L.uniformsList=No.seqWithValue($.seq,L.uniforms)}return L.uniformsList}function sa(L,$){let Q=ze.get(L);Q.outputColorSpace=$.outputColorSpace,Q.batching=$.batching,Q.batchingColor=$.batchingColor,Q.instancing=$.instancing,Q.instancingColor=$.instancingColor,Q.instancingMorph=$.instancingMorph,Q.skinning=$.skinning,Q.morphTargets=$.morphTargets,Q.morphNormals=$.morphNormals,Q.morphColors=$.morphColors,Q.morphTargetsCount=$.morphTargetsCount,Q.numClippingPlanes=$.numClippingPlanes,Q.numIntersection=$.numClipIntersection,Q.vertexAlphas=$.vertexAlphas,Q.vertexTangents=$.vertexTangents,Q.toneMapping=$.toneMapping}function ra(L,$,Q,Z,j){$.isScene!==!0&&($=we),Ye.resetTextureUnits();let Ce=$.fog,Ie=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial?$.environment:null,Re=se===null?P.outputColorSpace:se.isXRRenderTarget===!0?se.texture.colorSpace:St.workingColorSpace,Le=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial&&!Z.envMap||Z.isMeshPhongMaterial&&!Z.envMap,He=k.get(Z.envMap||Ie,Le),at=Z.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,mt=!!Q.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),Ge=!!Q.morphAttributes.position,gt=!!Q.morphAttributes.normal,tn=!!Q.morphAttributes.color,Ot=is;Z.toneMapped&&(se===null||se.isXRRenderTarget===!0)&&(Ot=P.toneMapping);let Ut=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,vn=Ut!==void 0?Ut.length:0,Ue=ze.get(Z),fn=M.state.lights;if(Bt===!0&&(en===!0||L!==J)){let Ft=L===J&&Z.id===Y;re.setState(Z,L,Ft)}let bt=!1,us=!1;Z.version===Ue.__version?Ue.needsLights&&Ue.lightsStateVersion!==fn.state.version||j.isBatchedMesh&&Ue.batching===!1||!j.isBatchedMesh&&Ue.batching===!0||j.isBatchedMesh&&Ue.batchingColor===!0&&j._colorsTexture===null||j.isBatchedMesh&&Ue.batchingColor===!1&&j._colorsTexture!==null||j.isInstancedMesh&&Ue.instancing===!1||!j.isInstancedMesh&&Ue.instancing===!0||j.isSkinnedMesh&&Ue.skinning===!1||!j.isSkinnedMesh&&Ue.skinning===!0||j.isInstancedMesh&&Ue.instancingColor===!0&&j.instanceColor===null||j.isInstancedMesh&&Ue.instancingColor===!1&&j.instanceColor!==null||j.isInstancedMesh&&Ue.instancingMorph===!0&&j.morphTexture===null||j.isInstancedMesh&&Ue.instancingMorph===!1&&j.morphTexture!==null||Ue.envMap!==He||Z.fog===!0&&Ue.fog!==Ce||Ue.numClippingPlanes!==void 0&&(Ue.numClippingPlanes!==re.numPlanes||Ue.numIntersection!==re.numIntersection)||Ue.vertexAlphas!==at||Ue.vertexTangents!==mt||Ue.morphTargets!==Ge||Ue.morphNormals!==gt||Ue.morphColors!==tn||Ue.morphTargetsCount!==vn||Ue.numLightProbeGrids!==cn(M.state.lightProbeGridArray)?bt=!0:(Ue.outputColorSpace!==Re||Ue.toneMapping!==Ot)&&(us=!0):(bt=!0,Ue.__version=Z.version);let pn=Ue.currentProgram;(bt===!0||us===!0)&&(pn=us===!0?ii(Z,$,j,Re,Ot):Wi(Z,$,j),D&&Z.isNodeMaterial&&D.onUpdateProgram(Z,pn,Ue));let qr=!1,$i=!1,hs=!1,ft=pn.getUniforms(),sn=Ue.uniforms;if(ye.useProgram(pn.program)&&(qr=!0,$i=!0,hs=!0),Z.id!==Y&&(Y=Z.id,$i=!0),qr||J!==L){ye.buffers.depth.getReversed()&&L.reversedDepth!==!0&&(L._reversedDepth=!0,L.updateProjectionMatrix()),ft.setValue(B,"projectionMatrix",L.projectionMatrix),ft.setValue(B,"viewMatrix",L.matrixWorldInverse);let mn=ft.map.cameraPosition;mn!==void 0&&mn.setValue(B,dn.setFromMatrixPosition(L.matrixWorld)),Qe.logarithmicDepthBuffer&&ft.setValue(B,"logDepthBufFC",2/(Math.log(L.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&ft.setValue(B,"isOrthographic",L.isOrthographicCamera===!0),J!==L&&(J=L,$i=!0,hs=!0)}if(Ue.needsLights&&(fn.state.sunShadowMap.length>0&&ft.setValue(B,"sunShadowMap",fn.state.sunShadowMap,Ye),fn.state.directionalShadowMap.length>0&&ft.setValue(B,"directionalShadowMap",fn.state.directionalShadowMap,Ye),fn.state.spotShadowMap.length>0&&ft.setValue(B,"spotShadowMap",fn.state.spotShadowMap,Ye),fn.state.pointShadowMap.length>0&&ft.setValue(B,"pointShadowMap",fn.state.pointShadowMap,Ye)),j.isSkinnedMesh){ft.setOptional(B,j,"bindMatrix"),ft.setOptional(B,j,"bindMatrixInverse");let Ft=j.skeleton;Ft&&(Ft.boneTexture===null&&Ft.computeBoneTexture(),ft.setValue(B,"boneTexture",Ft.boneTexture,Ye))}j.isBatchedMesh&&(ft.setOptional(B,j,"batchingTexture"),ft.setValue(B,"batchingTexture",j._matricesTexture,Ye),ft.setOptional(B,j,"batchingIdTexture"),ft.setValue(B,"batchingIdTexture",j._indirectTexture,Ye),ft.setOptional(B,j,"batchingColorTexture"),j._colorsTexture!==null&&ft.setValue(B,"batchingColorTexture",j._colorsTexture,Ye));let Hn=Q.morphAttributes;if((Hn.position!==void 0||Hn.normal!==void 0||Hn.color!==void 0)&&oe.update(j,Q,pn),($i||Ue.receiveShadow!==j.receiveShadow)&&(Ue.receiveShadow=j.receiveShadow,ft.setValue(B,"receiveShadow",j.receiveShadow)),(Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial)&&Z.envMap===null&&$.environment!==null&&(sn.envMapIntensity.value=$.environmentIntensity),sn.dfgLUT!==void 0&&(sn.dfgLUT.value=xE()),$i){if(ft.setValue(B,"toneMappingExposure",P.toneMappingExposure),Ue.needsLights&&$r(sn,hs),Ce&&Z.fog===!0&&ve.refreshFogUniforms(sn,Ce),ve.refreshMaterialUniforms(sn,Z,Se,be,M.state.transmissionRenderTarget[L.id]),Ue.needsLights&&Ue.numLightProbeGrids>0){let Ft=S,mn=0;for(let Un of M.state.lightProbeGridArray)Un.texture!==null&&(Ft.textures[mn]=Un.texture,Ft.min[mn]=Un.boundingBox.min,Ft.max[mn]=Un.boundingBox.max,Ft.resolution[mn]=Un.resolution,mn++);for(let Un in Ft)Ft[Un].length=mn;sn.probesSH.value=Ft.textures,sn.probesMin.value=Ft.min,sn.probesMax.value=Ft.max,sn.probesResolution.value=Ft.resolution}No.upload(B,Os(Ue),sn,Ye)}if(Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(No.upload(B,Os(Ue),sn,Ye),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&ft.setValue(B,"center",j.center),ft.setValue(B,"modelViewMatrix",j.modelViewMatrix),ft.setValue(B,"normalMatrix",j.normalMatrix),ft.setValue(B,"modelMatrix",j.matrixWorld),Z.uniformsGroups!==void 0){let Ft=Z.uniformsGroups;for(let mn=0,Un=Ft.length;mn<Un;mn++){let Ml=Ft[mn];Xe.update(Ml,pn),Xe.bind(Ml,pn)}}return pn}function $r(L,$){L.ambientLightColor.needsUpdate=$,L.lightProbe.needsUpdate=$,L.sunLights.needsUpdate=$,L.sunLightShadows.needsUpdate=$,L.directionalLights.needsUpdate=$,L.directionalLightShadows.needsUpdate=$,L.pointLights.needsUpdate=$,L.pointLightShadows.needsUpdate=$,L.spotLights.needsUpdate=$,L.spotLightShadows.needsUpdate=$,L.rectAreaLights.needsUpdate=$,L.hemisphereLights.needsUpdate=$}function Us(L){return L.isMeshLambertMaterial||L.isMeshToonMaterial||L.isMeshPhongMaterial||L.isMeshStandardMaterial||L.isShadowMaterial||L.isShaderMaterial&&L.lights===!0}this.getActiveCubeFace=function(){return W},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return se},this.setRenderTargetTextures=function(L,$,Q){let Z=ze.get(L);Z.__autoAllocateDepthBuffer=L.resolveDepthBuffer===!1,Z.__autoAllocateDepthBuffer===!1&&(Z.__useRenderToTexture=!1),ze.get(L.texture).__webglTexture=$,ze.get(L.depthTexture).__webglTexture=Z.__autoAllocateDepthBuffer?void 0:Q,Z.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(L,$){let Q=ze.get(L);Q.__webglFramebuffer=$,Q.__useDefaultFramebuffer=$===void 0},this.setRenderTarget=function(L,$=0,Q=0){se=L,W=$,H=Q;let Z=null,j=!1,Ce=!1;if(L){let Re=ze.get(L);if(Re.__useDefaultFramebuffer!==void 0){ye.bindFramebuffer(B.FRAMEBUFFER,Re.__webglFramebuffer),te.copy(L.viewport),pe.copy(L.scissor),fe=L.scissorTest,ye.viewport(te),ye.scissor(pe),ye.setScissorTest(fe),Y=-1;return}else if(Re.__webglFramebuffer===void 0)Ye.setupRenderTarget(L);else if(Re.__hasExternalTextures)Ye.rebindTextures(L,ze.get(L.texture).__webglTexture,ze.get(L.depthTexture).__webglTexture);else if(L.depthBuffer){let at=L.depthTexture;if(Re.__boundDepthTexture!==at){if(at!==null&&ze.has(at)&&(L.width!==at.image.width||L.height!==at.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ye.setupDepthRenderbuffer(L)}}let Le=L.texture;(Le.isData3DTexture||Le.isDataArrayTexture||Le.isCompressedArrayTexture)&&(Ce=!0);let He=ze.get(L).__webglFramebuffer;L.isWebGLCubeRenderTarget?(Array.isArray(He[$])?Z=He[$][Q]:Z=He[$],j=!0):L.samples>0&&Ye.useMultisampledRTT(L)===!1?Z=ze.get(L).__webglMultisampledFramebuffer:Array.isArray(He)?Z=He[Q]:Z=He,te.copy(L.viewport),pe.copy(L.scissor),fe=L.scissorTest}else te.copy(We).multiplyScalar(Se).floor(),pe.copy(lt).multiplyScalar(Se).floor(),fe=ct;if(Q!==0&&(Z=U),ye.bindFramebuffer(B.FRAMEBUFFER,Z)&&ye.drawBuffers(L,Z),ye.viewport(te),ye.scissor(pe),ye.setScissorTest(fe),j){let Re=ze.get(L.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+$,Re.__webglTexture,Q)}else if(Ce){let Re=$;for(let Le=0;Le<L.textures.length;Le++){let He=ze.get(L.textures[Le]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+Le,He.__webglTexture,Q,Re)}}else if(L!==null&&Q!==0){let Re=ze.get(L.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Re.__webglTexture,Q)}Y=-1};function Xr(L){let $=ze.get(L);return($.__readFormat!==L.format||$.__readType!==L.type)&&($.__readFormat=L.format,$.__readType=L.type,$.__formatReadable=Qe.textureFormatReadable(L.format),$.__typeReadable=Qe.textureTypeReadable(L.type)),$}this.readRenderTargetPixels=function(L,$,Q,Z,j,Ce,Ie,Re=0){if(!(L&&L.isWebGLRenderTarget)){st("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Le=ze.get(L).__webglFramebuffer;if(L.isWebGLCubeRenderTarget&&Ie!==void 0&&(Le=Le[Ie],Array.isArray(Le)&&(Le=Le[0])),Le){ye.bindFramebuffer(B.FRAMEBUFFER,Le);try{let He=L.textures[Re],at=He.format,mt=He.type;L.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Re);let Ge=Xr(He);if(Ge.__formatReadable===!1){st("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ge.__typeReadable===!1){st("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}$>=0&&$<=L.width-Z&&Q>=0&&Q<=L.height-j&&B.readPixels($,Q,Z,j,_e.convert(at),_e.convert(mt),Ce)}finally{let He=se!==null?ze.get(se).__webglFramebuffer:null;ye.bindFramebuffer(B.FRAMEBUFFER,He)}}},this.readRenderTargetPixelsAsync=async function(L,$,Q,Z,j,Ce,Ie,Re=0){if(!(L&&L.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Le=ze.get(L).__webglFramebuffer;if(L.isWebGLCubeRenderTarget&&Ie!==void 0&&(Le=Le[Ie],Array.isArray(Le)&&(Le=Le[0])),Le)if($>=0&&$<=L.width-Z&&Q>=0&&Q<=L.height-j){ye.bindFramebuffer(B.FRAMEBUFFER,Le);let He=L.textures[Re],at=He.format,mt=He.type;L.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Re);let Ge=Xr(He);if(Ge.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ge.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let gt=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,gt),B.bufferData(B.PIXEL_PACK_BUFFER,Ce.byteLength,B.STREAM_READ),B.readPixels($,Q,Z,j,_e.convert(at),_e.convert(mt),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let tn=se!==null?ze.get(se).__webglFramebuffer:null;ye.bindFramebuffer(B.FRAMEBUFFER,tn);let Ot=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await Ug(B,Ot,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,gt),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Ce),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(gt),B.deleteSync(Ot),Ce}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(L,$=null,Q=0){let Z=Math.pow(2,-Q),j=Math.floor(L.image.width*Z),Ce=Math.floor(L.image.height*Z),Ie=$!==null?$.x:0,Re=$!==null?$.y:0;Ye.setTexture2D(L,0),B.copyTexSubImage2D(B.TEXTURE_2D,Q,0,0,Ie,Re,j,Ce),ye.unbindTexture()},this.copyTextureToTexture=function(L,$,Q=null,Z=null,j=0,Ce=0){let Ie,Re,Le,He,at,mt,Ge,gt,tn,Ot=L.isCompressedTexture?L.mipmaps[Ce]:L.image;if(Q!==null)Ie=Q.max.x-Q.min.x,Re=Q.max.y-Q.min.y,Le=Q.isBox3?Q.max.z-Q.min.z:1,He=Q.min.x,at=Q.min.y,mt=Q.isBox3?Q.min.z:0;else{let ft=Math.pow(2,-j);Ie=Math.floor(Ot.width*ft),Re=Math.floor(Ot.height*ft),L.isDataArrayTexture?Le=Ot.depth:L.isData3DTexture?Le=Math.floor(Ot.depth*ft):Le=1,He=0,at=0,mt=0}Z!==null?(Ge=Z.x,gt=Z.y,tn=Z.z):(Ge=0,gt=0,tn=0);let Ut=_e.convert($.format),vn=_e.convert($.type),Ue;$.isData3DTexture?(Ye.setTexture3D($,0),Ue=B.TEXTURE_3D):$.isDataArrayTexture||$.isCompressedArrayTexture?(Ye.setTexture2DArray($,0),Ue=B.TEXTURE_2D_ARRAY):(Ye.setTexture2D($,0),Ue=B.TEXTURE_2D),ye.activeTexture(B.TEXTURE0),ye.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,$.flipY),ye.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,$.premultiplyAlpha),ye.pixelStorei(B.UNPACK_ALIGNMENT,$.unpackAlignment);let fn=ye.getParameter(B.UNPACK_ROW_LENGTH),bt=ye.getParameter(B.UNPACK_IMAGE_HEIGHT),us=ye.getParameter(B.UNPACK_SKIP_PIXELS),pn=ye.getParameter(B.UNPACK_SKIP_ROWS),qr=ye.getParameter(B.UNPACK_SKIP_IMAGES);ye.pixelStorei(B.UNPACK_ROW_LENGTH,Ot.width),ye.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Ot.height),ye.pixelStorei(B.UNPACK_SKIP_PIXELS,He),ye.pixelStorei(B.UNPACK_SKIP_ROWS,at),ye.pixelStorei(B.UNPACK_SKIP_IMAGES,mt);let $i=L.isDataArrayTexture||L.isData3DTexture,hs=$.isDataArrayTexture||$.isData3DTexture;if(L.isDepthTexture){let ft=ze.get(L),sn=ze.get($),Hn=ze.get(ft.__renderTarget),Ft=ze.get(sn.__renderTarget);ye.bindFramebuffer(B.READ_FRAMEBUFFER,Hn.__webglFramebuffer),ye.bindFramebuffer(B.DRAW_FRAMEBUFFER,Ft.__webglFramebuffer);for(let mn=0;mn<Le;mn++)$i&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ze.get(L).__webglTexture,j,mt+mn),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ze.get($).__webglTexture,Ce,tn+mn)),B.blitFramebuffer(He,at,He+Ie,at+Re,Ge,gt,Ge+Ie,gt+Re,B.DEPTH_BUFFER_BIT,B.NEAREST);ye.bindFramebuffer(B.READ_FRAMEBUFFER,null),ye.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(j!==0||L.isRenderTargetTexture||ze.has(L)){let ft=ze.get(L),sn=ze.get($);ye.bindFramebuffer(B.READ_FRAMEBUFFER,N),ye.bindFramebuffer(B.DRAW_FRAMEBUFFER,z);for(let Hn=0;Hn<Le;Hn++)$i?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ft.__webglTexture,j,mt+Hn):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,ft.__webglTexture,j),hs?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,sn.__webglTexture,Ce,tn+Hn):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,sn.__webglTexture,Ce),j!==0?B.blitFramebuffer(He,at,He+Ie,at+Re,Ge,gt,Ge+Ie,gt+Re,B.COLOR_BUFFER_BIT,B.NEAREST):hs?B.copyTexSubImage3D(Ue,Ce,Ge,gt,tn+Hn,He,at,Ie,Re):B.copyTexSubImage2D(Ue,Ce,Ge,gt,He,at,Ie,Re);ye.bindFramebuffer(B.READ_FRAMEBUFFER,null),ye.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else hs?L.isDataTexture||L.isData3DTexture?B.texSubImage3D(Ue,Ce,Ge,gt,tn,Ie,Re,Le,Ut,vn,Ot.data):$.isCompressedArrayTexture?B.compressedTexSubImage3D(Ue,Ce,Ge,gt,tn,Ie,Re,Le,Ut,Ot.data):B.texSubImage3D(Ue,Ce,Ge,gt,tn,Ie,Re,Le,Ut,vn,Ot):L.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Ce,Ge,gt,Ie,Re,Ut,vn,Ot.data):L.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Ce,Ge,gt,Ot.width,Ot.height,Ut,Ot.data):B.texSubImage2D(B.TEXTURE_2D,Ce,Ge,gt,Ie,Re,Ut,vn,Ot);ye.pixelStorei(B.UNPACK_ROW_LENGTH,fn),ye.pixelStorei(B.UNPACK_IMAGE_HEIGHT,bt),ye.pixelStorei(B.UNPACK_SKIP_PIXELS,us),ye.pixelStorei(B.UNPACK_SKIP_ROWS,pn),ye.pixelStorei(B.UNPACK_SKIP_IMAGES,qr),Ce===0&&$.generateMipmaps===!0&&$.mipmapsAutoUpdate===!0&&B.generateMipmap(Ue),ye.unbindTexture()},this.initRenderTarget=function(L){ze.get(L).__webglFramebuffer===void 0&&Ye.setupRenderTarget(L)},this.initTexture=function(L){L.isCubeTexture?Ye.setTextureCube(L,0):L.isData3DTexture?Ye.setTexture3D(L,0):L.isDataArrayTexture||L.isCompressedArrayTexture?Ye.setTexture2DArray(L,0):Ye.setTexture2D(L,0),ye.unbindTexture()},this.resetState=function(){W=0,H=0,se=null,ye.reset(),Ee.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Si}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=St._getDrawingBufferColorSpace(e),t.unpackColorSpace=St._getUnpackColorSpace()}};function Nr(n){let e=new Ts;return e.userData.nearer=n,n===0||(e.onBeforeCompile=t=>{t.vertexShader=t.vertexShader.replace("#include <project_vertex>",`#include <project_vertex>
      vec4 pulled = vec4(mvPosition.xyz - normalize(mvPosition.xyz) * ${n.toExponential()}, 1.0);
      vec4 nearPosition = projectionMatrix * pulled;
      gl_Position.z = nearPosition.z / nearPosition.w * gl_Position.w;`)},e.customProgramCacheKey=()=>`nearer ${n}`),e}function ko(n,e,t,i,s,r){let o=n[t]-n[e],a=n[t+1]-n[e+1],l=n[t+2]-n[e+2],c=Math.hypot(o,a,l)||1e-12;o/=c,a/=c,l/=c;let h=Math.abs(l)<.9,[u,d,f]=h?[a,-o,0]:[0,l,-a],p=Math.hypot(u,d,f);u/=p,d/=p,f/=p,s[r]=i*u,s[r+1]=i*d,s[r+2]=i*f,s[r+4]=c*o,s[r+5]=c*a,s[r+6]=c*l,s[r+8]=i*(d*l-f*a),s[r+9]=i*(f*o-u*l),s[r+10]=i*(u*a-d*o);for(let x=0;x<3;x++)s[r+12+x]=(n[e+x]+n[t+x])/2;s[r+15]=1}var Eu="#d55e00",Tu="#0072b2",w0=["#e2cf9f","#c5bcd9","#b7cfa2","#d6aeb9","#9cc4dd","#cfcfcf"],M0=["#735826","#54458a","#35693a","#8c4467","#0b5a8a","#525252"];function E0(n){return M0[n%M0.length]}function tl(n){return w0[n%w0.length]}var _E=["#453781","#39568c","#2d708e","#20908d","#29af7f","#73d055","#b8de29","#fde725"],yE=["#00224e","#083370","#35456c","#4f576c","#666970","#7d7c78","#948e77","#aea371","#c8b866","#e5cf52","#fee838"],vE=["#ffffcc","#ffeda0","#fed976","#feb24c","#fd8c3c","#fc4d2a","#e2191c","#bb0026","#800026"];function _f(n){let e=n.map(i=>[1,3,5].map(s=>parseInt(i.slice(s,s+2),16)/255));function t(i,s=[0,0,0]){let r=Math.min(1,Math.max(0,i))*(n.length-1),o=Math.min(n.length-2,Math.floor(r));for(let a=0;a<3;a++){let l=e[o][a];s[a]=l+(r-o)*(e[o+1][a]-l)}return s}return{at:t,gradient:`linear-gradient(to right, ${n.join(", ")})`}}var Oo=_f(_E),T0=_f(yE),Cu=_f(vE),xf=null;function _t(n){return getComputedStyle(xf??document.documentElement).getPropertyValue(n).trim()}function yf(){let n=document.createElement("div");return n.className="paper",document.body.append(n),xf=n,()=>{xf=null,n.remove()}}function C0(n){let e=yf();try{return n()}finally{e()}}function sr(n){let e=matchMedia("(prefers-color-scheme: dark)");return e.addEventListener("change",n),()=>e.removeEventListener("change",n)}var A0=[[],[8,4],[8,3,2,3],[2,3]],bE=7;function Fi(n){return{colour:_t(`--line-${n%bE}`),dash:A0[n%A0.length]}}var SE=32767,rr=24,wE=5/3*Math.PI,ME=.22,vf=.11,R0=.7,P0=3,I0=1e-6;function L0(n){let e=n.turns.map(l=>({...l,pivot:Kt(l.pivot,Float32Array),axis:Float32Array.from(Kt(l.axis,Int16Array),c=>c/SE),left:l.left&&Kt(l.left,Float32Array)})),t=n.pushes.map(l=>({...l,force:l.force&&Kt(l.force,Float32Array)})),{drives:i,stages:s}=n;function r(l){let c=s.find(({start:h,end:u})=>l>h&&l<=u);return i.map(({strength:h,rise:u},d)=>c?.drives.includes(d)?h*(u>0?Math.min(1,(l-c.start)/u):1):0)}let o=(l,c)=>l.reduce((h,u,d)=>h+u*c[d],0),a=l=>l.reduce((c,{shares:h})=>{let u=s.map(d=>Math.abs(o(h,i.map(({strength:f},p)=>d.drives.includes(p)?f:0))));return Math.max(c,...u)},0);return{...n,time:Kt(n.time,Float64Array),turns:e,pushes:t,strengthsAt:r,summed:o,largestTurn:a(e),largestPush:a(t)}}function N0({drives:n,strengthsAt:e},t,i){let s=e(t);return n.flatMap(({text:r,unit:o,factor:a},l)=>s[l]?[`${r}: ${i(a*s[l])} ${o}`]:[])}function D0(n){let{time:e,turns:t,pushes:i,strengthsAt:s,summed:r,largestTurn:o,largestPush:a}=n.efforts,l=Math.max(0,...t.map(T=>T.radius)),c=.05*n.mesh.span_m,h=Nr(Math.max(l,c)),u=new fi(new wi(1,1,1,10),h,t.length*rr+i.length),d=new fi(new Er(1,1,16),h,t.length+i.length),f=new Ln;for(let T of[u,d])T.frustumCulled=!1,f.add(T);let p=new Float32Array(3*(rr+2)),[x,m]=[0,0],g=(T,P,C,D,U)=>ko(p,3*P,3*C,D,T.instanceMatrix.array,16*U);function _(T,P){for(let C=0;C<3;C++)p[3*T+C]=P[C]}function w(T,P,C,D){let[U,N]=Dr(e,C),W=(T.left?bf(T.left,1,U,N)[0]:1)*r(T.shares,D)/o;if(!(Math.abs(W)>I0))return;let[H,se]=T.ends?AE(P,T.ends):[T.pivot,T.axis].map(he=>bf(he,3,U,N)),Y=TE(se,T),J=EE(se,Y),te=wE*Math.min(1.2,Math.abs(W))*Math.sign(W),pe=he=>H.map((xe,be)=>xe+T.radius*(Math.cos(he)*Y[be]+Math.sin(he)*J[be]));for(let he=0;he<=rr;he++)_(he,pe(te*(he/rr-.5)));let fe=te/2;_(rr+1,pe(fe+Math.sign(W)*R0));let ee=vf*T.radius;for(let he=0;he<rr;he++)g(u,he,he+1,ee,x++);g(d,rr,rr+1,P0*ee,m++)}function S(T,P,C,D){let[U,N]=Dr(e,C),z=T.force?bf(T.force,1,U,N)[0]:r(T.shares,D)/a;if(!(Math.abs(z)>I0))return;let W=ME*n.mesh.span_m*z,H=P.subarray(3*T.point,3*T.point+3),se=Y=>T.direction.map((J,te)=>H[te]+Y*J);_(0,H),_(1,se(W)),_(2,se(W+Math.sign(z)*R0*c)),g(u,0,1,vf*c,x++),g(d,1,2,P0*vf*c,m++)}function A(T){[x,m]=[0,0];let P=s(T),C=n.pointsAt(T);for(let D of t)w(D,C,T,P);for(let D of i)S(D,C,T,P);[u.count,d.count]=[x,m];for(let D of[u,d])D.instanceMatrix.needsUpdate=!0}let M=()=>h.color.set(new je(_t("--effort")));function y(){for(let T of[u,d])T.dispose(),T.geometry.dispose();h.dispose()}return{group:f,pose:A,paint:M,count:()=>m,dispose:y}}function bf(n,e,t,i){if(n.length===e)return Array.from(n);let s=Math.min(t+1,n.length/e-1);return Array.from({length:e},(r,o)=>{let a=n[t*e+o];return a+i*(n[s*e+o]-a)})}function AE(n,[e,t]){let[i,s]=[e,t].map(a=>Array.from(n.subarray(3*a,3*a+3))),r=i.map((a,l)=>s[l]-a),o=Math.hypot(...r)||1;return[i.map((a,l)=>(a+s[l])/2),r.map(a=>a/o)]}function EE(n,e){return[0,1,2].map(t=>n[(t+1)%3]*e[(t+2)%3]-n[(t+2)%3]*e[(t+1)%3])}function TE(n,e){e.side??=n.map(Math.abs).reduce((r,o,a,l)=>o<l[r]-.001?a:r,2);let t=n[e.side],i=n.map((r,o)=>(o===e.side?1:0)-t*r),s=Math.hypot(...i)||1;return i.map(r=>r/s)}var Is="tendon energy",wf=Symbol("readings of single creases");function Kt(n,e){let t=atob(n),i=new Uint8Array(t.length);for(let s=0;s<t.length;s++)i[s]=t.charCodeAt(s);return new e(i.buffer)}function k0({low:n,step:e,steps:t}){return Float32Array.from(Kt(t,Uint16Array),(i,s)=>n[s%n.length]+e[s%n.length]*i)}function Kn(n){let e=Kt(n.time,Float64Array),t=typeof n.points=="string"?Kt(n.points,Float32Array):k0(n.points),i=3*n.pointCount,s={[Is]:{width:n.tendonParts.length,values:Kt(n.tendonEnergy_J,Float32Array)}};for(let _ of n.readings)s[_.name]={width:_.parts.length,values:Kt(_.values,Float32Array)};let{creases:r=null}=n,o=(n.along??[]).map(_=>({..._,key:Symbol(_.name)}));for(let{key:_,values:w}of o)s[_]={width:1,values:Kt(w,Float32Array)};r&&(s[wf]={width:r.values.low.length,values:k0(r.values)});let a=Int32Array.from(n.between),l=Float64Array.from(n.share),c=new Float32Array(i);function h(_,w=c){return Sf(e,t,i,_,w),w}function u(_,w=new Float32Array(3*l.length)){return d(h(_),w)}function d(_,w){for(let S=0;S<l.length;S++){let A=3*a[2*S],M=3*a[2*S+1];for(let y=0;y<3;y++){let b=_[A+y];w[3*S+y]=b+l[S]*(_[M+y]-b)}}return w}function f(_,w,S=new Float32Array(s[_].width)){return Sf(e,s[_].values,s[_].width,w,S),S}function p(_,w){let{width:S,values:A}=s[_];return Float32Array.from(e,(M,y)=>A[y*S+w])}let x=Kt(n.restLength_m,Float32Array);function m(_,w){x.length===w.length?w.set(x):Sf(e,x,w.length,_,w)}let g=n.efforts&&L0(n.efforts);return{name:n.name,reach:Math.max(n.base.radius,g?.pushes.length?.12*n.span_m:0,...(g?.turns??[]).map(_=>.4*_.radius)),mesh:n,marks:n.marks,stages:n.stages,tendons:n.tendonParts.length,readings:n.readings,along:o,creases:r,time:e,start:e[0],end:e[e.length-1],efforts:g,strained:n.built!==null,stressed:!!n.membraneLaw,builtVertices:()=>d(Kt(n.built,Float32Array),new Float32Array(3*l.length)),restLengthsAt:m,pointsAt:h,verticesAt:u,verticesOf:d,valuesAt:f,line:p,stageAt:_=>n.stages.findLast(w=>w.start<=_)??n.stages[0],markAt:_=>n.marks.find(w=>Math.abs(w.time-_)<1e-9)}}function Sf(n,e,t,i,s){let[r,o]=Dr(n,i),a=r*t,l=Math.min(r+1,n.length-1)*t;for(let c=0;c<t;c++){let h=e[a+c];s[c]=o===0?h:h+o*(e[l+c]-h)}}function Dr(n,e){if(!(e>n[0]))return[0,0];let t=n.length-1;if(e>=n[t])return[t,0];let i=0,s=t;for(;s-i>1;){let r=i+s>>1;n[r]<=e?i=r:s=r}return[i,(e-n[i])/(n[i+1]-n[i])]}function or(n,e,t){let[i,s]=Dr(n,t);return s===0?e[i]:e[i]+s*(e[i+1]-e[i])}function Ru(){return document.getElementById("engine-program")!==null}async function Uo(n,e){let t=new Blob([Kt(document.getElementById("engine-script").textContent,Uint8Array)]).stream(),i=await new Response(t.pipeThrough(new DecompressionStream("deflate"))).text(),s=URL.createObjectURL(new Blob([i],{type:"text/javascript"})),r=new Worker(s),o=new Map,a=0;r.onmessage=({data:h})=>{let u=o.get(h.to);u?(o.delete(h.to),h.said==="refused"?u.refuse(new Error(h.why)):u.take(h)):e(h)},r.onerror=h=>{h.preventDefault();let u=new Error(h.message||"the engine stopped");for(let{refuse:d}of o.values())d(u);o.clear(),e({said:"refused",why:u.message})};function l(h){let u=++a;return new Promise((d,f)=>{o.set(u,{take:d,refuse:f}),r.postMessage({...h,number:u})})}function c(){r.terminate(),URL.revokeObjectURL(s)}try{let h=document.getElementById("engine-program").textContent,{frame:u,version:d}=await l({act:"load",program:h,text:n}),f={first:u,version:d,ask:l,send:x=>r.postMessage(x),take:p,end:c};return f;async function p(x,m){let{frame:g}=await l({act:"load",text:x});return e=m,{...f,first:g}}}catch(h){throw c(),h}}var O0={type:"change"},Af={type:"start"},F0={type:"end"},Pu=new Ys,U0=new ui,CE=Math.cos(70*tf.DEG2RAD),Mn=new G,ni=2*Math.PI,Pt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Mf=1e-6,Iu=class extends Va{constructor(e,t=null){super(e,t),this.state=Pt.NONE,this.target=new G,this.cursor=new G,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:er.ROTATE,MIDDLE:er.DOLLY,RIGHT:er.PAN},this.touches={ONE:tr.ROTATE,TWO:tr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new G,this._lastQuaternion=new hi,this._lastTargetPosition=new G,this._quat=new hi().setFromUnitVectors(e.up,new G(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new To,this._sphericalDelta=new To,this._scale=1,this._panOffset=new G,this._rotateStart=new Je,this._rotateEnd=new Je,this._rotateDelta=new Je,this._panStart=new Je,this._panEnd=new Je,this._panDelta=new Je,this._dollyStart=new Je,this._dollyEnd=new Je,this._dollyDelta=new Je,this._dollyDirection=new G,this._mouse=new Je,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=PE.bind(this),this._onPointerDown=RE.bind(this),this._onPointerUp=IE.bind(this),this._onContextMenu=FE.bind(this),this._onMouseWheel=DE.bind(this),this._onKeyDown=kE.bind(this),this._onTouchStart=OE.bind(this),this._onTouchMove=UE.bind(this),this._onMouseDown=LE.bind(this),this._onMouseMove=NE.bind(this),this._interceptControlDown=BE.bind(this),this._interceptControlUp=zE.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Pt.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(O0),this.update(),this.state=Pt.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Mn.copy(t).sub(this.target),Mn.applyQuaternion(this._quat),this._spherical.setFromVector3(Mn),this.autoRotate&&this.state===Pt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ni:i>Math.PI&&(i-=ni),s<-Math.PI?s+=ni:s>Math.PI&&(s-=ni),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Mn.setFromSpherical(this._spherical),Mn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Mn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Mn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new G(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new G(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Mn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Pu.origin.copy(this.object.position),Pu.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Pu.direction))<CE?this.object.lookAt(this.target):(U0.setFromNormalAndCoplanarPoint(this.object.up,this.target),Pu.intersectPlane(U0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Mf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Mf||this._lastTargetPosition.distanceToSquared(this.target)>Mf?(this.dispatchEvent(O0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?ni/60*this.autoRotateSpeed*e:ni/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Mn.setFromMatrixColumn(t,0),Mn.multiplyScalar(-e),this._panOffset.add(Mn)}_panUp(e,t){this.screenSpacePanning===!0?Mn.setFromMatrixColumn(t,1):(Mn.setFromMatrixColumn(t,0),Mn.crossVectors(this.object.up,Mn)),Mn.multiplyScalar(e),this._panOffset.add(Mn)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Mn.copy(s).sub(this.target);let r=Mn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ni*this._rotateDelta.x/t.clientHeight),this._rotateUp(ni*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(ni*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-ni*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(ni*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-ni*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ni*this._rotateDelta.x/t.clientHeight),this._rotateUp(ni*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Je,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function RE(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function PE(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function IE(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(F0),this.state=Pt.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function LE(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case er.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Pt.DOLLY;break;case er.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Pt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Pt.ROTATE}break;case er.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Pt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Pt.PAN}break;default:this.state=Pt.NONE}this.state!==Pt.NONE&&this.dispatchEvent(Af)}function NE(n){switch(this.state){case Pt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Pt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Pt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function DE(n){this.enabled===!1||this.enableZoom===!1||this.state!==Pt.NONE||(n.preventDefault(),this.dispatchEvent(Af),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(F0))}function kE(n){this.enabled!==!1&&this._handleKeyDown(n)}function OE(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case tr.ROTATE:if(this.enableRotate===!1){this.state=Pt.NONE;break}this._handleTouchStartRotate(n),this.state=Pt.TOUCH_ROTATE;break;case tr.PAN:if(this.enablePan===!1){this.state=Pt.NONE;break}this._handleTouchStartPan(n),this.state=Pt.TOUCH_PAN;break;default:this.state=Pt.NONE}break;case 2:switch(this.touches.TWO){case tr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Pt.TOUCH_DOLLY_PAN;break;case tr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Pt.TOUCH_DOLLY_ROTATE;break;default:this.state=Pt.NONE}break;default:this.state=Pt.NONE}this.state!==Pt.NONE&&this.dispatchEvent(Af)}function UE(n){switch(this._trackPointer(n),this.state){case Pt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Pt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Pt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Pt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Pt.NONE}}function FE(n){this.enabled!==!1&&n.preventDefault()}function BE(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function zE(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Ef=120,B0=2,z0=6;function Tf(n,e,t){let i=new WeakMap,s=e.reduce((l,c)=>n[c].mesh.tubes.reduce((h,u)=>Math.max(h,u.radius),Math.max(l,n[c].reach)),Math.max(...e.map(l=>n[l].mesh.joints.length?n[l].mesh.jointRadius:0))),r=null;function o(){let{span:l}=t;if(!i.has(l)){let c=Array.from({length:Ef+1},(h,u)=>t.timeAt(u/Ef));i.set(l,c.map(h=>e.map(u=>n[u].pointsAt(t.clipTime(u,h)).slice())))}return i.get(l)}function a(l,c){let h=[...l.flatMap(d=>d.toArray()),...c].join();if(r?.key===h&&r.span===t.span)return r;let u=o().map(d=>VE(d,l,c,s));return r={key:h,span:t.span,rows:GE(u),whole:V0(u)},r}return function(c,h,u,d){let f=new G().crossVectors(h,c).normalize(),p=[f,new G().crossVectors(c,f),c],{rows:x,whole:m}=a(p,u),g=d?HE(x,t.wayAt(t.time)*Ef):m,[_,w,S,A,M,y]=g,b=[(_-w)/2,(S-A)/2,(M-y)/2],T=Math.max((_+w)/(2*u[0]),(S+A)/(2*u[1])),P=new G;for(let[C,D]of p.entries())P.addScaledVector(D,b[C]);return{target:P,distance:T-b[2]||1}}}function VE(n,e,t,i){let s=new Float64Array(z0).fill(-1/0),r=t.map(u=>i*Math.hypot(1,u)),o=[r[0],r[0],r[1],r[1],0,0],[a,l,c]=e.map(u=>u.toArray()),h=(u,d,f)=>u[0]*d[f]+u[1]*d[f+1]+u[2]*d[f+2];for(let u of n)for(let d=0;d<u.length;d+=3){let[f,p,x]=[h(a,u,d),h(l,u,d),h(c,u,d)],[m,g]=[t[0]*x,t[1]*x],_=[f+m,m-f,p+g,g-p,x,-x];for(let w=0;w<z0;w++)_[w]>s[w]&&(s[w]=_[w])}return s.map((u,d)=>u+o[d])}function V0(n){return n.reduce((e,t)=>e.map((i,s)=>Math.max(i,t[s])))}function GE(n){let e=(i,s)=>i.slice(Math.max(0,s-B0),s+B0+1),t=n.map((i,s)=>V0(e(n,s)));return n.map((i,s)=>{let r=e(t,s);return r[0].map((o,a)=>r.reduce((l,c)=>l+c[a],0)/r.length)})}function HE(n,e){let t=Math.min(n.length-2,Math.max(0,Math.floor(e))),i=Math.min(1,Math.max(0,e-t));return n[t].map((s,r)=>s+i*(n[t+1][r]-s))}var G0=28,WE=1.05,H0=Math.PI/24,$E=1.15,kr=[{name:"3-D",text:"obliquely from above",towards:[.37,-.695,.616]},{name:"top",text:"from above",towards:[0,-5e-4,1]},{name:"side",text:"from the side, along the flat plane",towards:[0,-1,1e-4]},{name:"along",text:"from the far end, along the centre line",towards:[1,0,1e-4]}];function W0(n,e,t,i,s=ar()){let{size:r,target:o}=XE(e),a=e.map((A,M)=>M),l=Tf(e,a,t),c=a.map(A=>Tf(e,[A],t)),h=new Yn(G0,1,.02*r,60*r);h.up.set(0,0,1);let u=new Iu(h,n);u.minDistance=.1*r,u.maxDistance=20*r;let d=null;function f(A=0){let M=s.oneScale?l:c[A],y=Math.tan(G0*Math.PI/360)/WE;d=M(s.towards,h.up,[y*h.aspect,y],s.following),s.oneScale&&(d.distance*=s.scale),u.target.copy(d.target).addScaledVector(s.aside,d.distance),h.position.copy(u.target).addScaledVector(s.towards,s.closer*d.distance),h.lookAt(u.target),h.updateMatrixWorld()}function p(){f(),i()}u.addEventListener("change",()=>{let A=h.position.clone().sub(u.target);s.closer=A.length()/d.distance,s.towards.copy(A).normalize(),s.aside.copy(u.target).sub(d.target).divideScalar(d.distance),p()});let x=A=>{document.activeElement!==n&&!A.ctrlKey&&A.stopImmediatePropagation()};n.parentElement.addEventListener("wheel",x,{capture:!0});function m({towards:A}){s.towards.set(...A).normalize(),s.closer=1,s.aside.set(0,0,0),p()}function g(A,M){let y=s.towards.clone().applyAxisAngle(h.up,A*H0),b=new G().crossVectors(h.up,y).normalize(),T=y.clone().applyAxisAngle(b,-M*H0);s.towards.copy(Math.abs(T.z)<.9999?T:y),p()}function _(A){let M=s.closer*d.distance*$E**-A;s.closer=Math.min(u.maxDistance,Math.max(u.minDistance,M))/d.distance,p()}function w(A){Object.assign(s,A),p()}function S(A,M){h.aspect=A,h.updateProjectionMatrix(),u.rotateSpeed=M,u.panSpeed=M,p()}return{camera:h,controls:u,look:s,size:r,target:o,aim:f,show:m,turn:g,zoom:_,choose:w,resize:S,dispose:()=>u.dispose()}}function ar(){return{towards:new G(...kr[0].towards).normalize(),closer:1,aside:new G,following:!0,oneScale:!0,scale:1}}function XE(n){let e=new G(1/0,1/0,1/0),t=new G(-1/0,-1/0,-1/0),i=new G;for(let r of n){let o=Math.max(1,Math.floor(r.time.length/60));for(let a=0;a<r.time.length;a+=o){let l=r.pointsAt(r.time[a]);for(let c=0;c<l.length;c+=3)i.fromArray(l,c),e.min(i),t.max(i)}}let s=e.clone().add(t).multiplyScalar(.5);return{target:s,size:t.distanceTo(s)||1}}function Fo(n,e,{clientWidth:t,clientHeight:i}){let{x:s,y:r}=n.project(e);return[(s+1)/2*t,(1-r)/2*i]}var nl=1/0,Cf=1e-4;function $0(n,e,t){let i=new Set,s=n.readings.map(({unit:p})=>(p==="deg"?1:e.units.length)*wm(p)),r={start:n.start,end:Math.max(n.end,n.start+1),origins:[0],whole:!0},o=t,a=t,l=0;function c(){l||=requestAnimationFrame(()=>{l=0;for(let p of i)p()})}let h=(p,x)=>p!==nl?n.pointsAt(p,x):x?(x.set(o.points),x):o.points,u={...n,marks:[],efforts:null,stressed:!1,reach:n.mesh.base.radius,pointsAt:h,verticesAt:(p,x)=>p===nl?n.verticesOf(o.points,x):n.verticesAt(p,x),valuesAt(p,x,m){if(x!==nl)return n.valuesAt(p,x,m);let g=n.readings.findIndex(w=>w.name===p),_=p===Is?o.energies_J:o.readings[g].map(w=>s[g]*w);return m?(m.set(_),m):Float32Array.from(_)},restLengthsAt(p,x){p===nl?x.set(o.restLengths_m):n.restLengthsAt(p,x)},markAt:()=>{}},d={get time(){return o.time_s},span:r,clipTime:(p,x=nl)=>x,timeAt:p=>r.start+p*(r.end-r.start),wayAt:()=>0,onChange(p){return i.add(p),c(),()=>i.delete(p)}};function f(p){o=p,!(p!==a&&!qE(p,a,Cf*u.reach))&&(a=p,c())}return{clip:u,clock:d,show:f,get frame(){return o}}}function qE(n,e,t){let i=(s,r,o)=>s.some((a,l)=>Math.abs(a-r[l])>o);return i(n.points,e.points,t)||n.readings.some((s,r)=>i(s,e.readings[r],Cf*Math.max(1,...s.map(Math.abs))))||i(n.energies_J,e.energies_J,Cf*Math.max(...e.energies_J))||i(n.restLengths_m,e.restLengths_m,0)}var YE=16,ZE=6;function X0(n,e,t){let{lines:i}=e.creases,[s,r]=[n.canvas,n.cells[0]],o=v("p",{className:"crease-label","aria-hidden":"true",hidden:!0}),a=v("span",{className:"crease-mark","aria-hidden":"true",hidden:!0});r.append(a,o);let l=v("select",{},v("option",{value:""},"none"),...i.map(({name:y},b)=>v("option",{value:String(b)},y))),c=v("output",{"aria-live":"off"}),h=v("span",{},"or point at one in the picture, or touch it"),u=new G,d=null,f=null,p=null;function x(y){return Fo(u.fromArray(n.views[0].shape.vertices,3*y),n.eye.camera,r)}function m(y){let b=s.getBoundingClientRect(),T=[y.clientX-b.left,y.clientY-b.top],[P,C]=[null,YE];for(let[D,{ends:U}]of i.entries()){let N=jE(T,...U.map(x))+g(U);N<C&&([P,C]=[D,N])}return P}let g=y=>u.fromArray(_(y)).distanceTo(n.eye.camera.position)/(1e3*n.eye.size);function _(y){let{vertices:b}=n.views[0].shape;return[0,1,2].map(T=>(b[3*y[0]+T]+b[3*y[1]+T])/2)}function w(y){let{lines:b,columns:T}=e.creases,P=e.valuesAt(wf,t.clipTime(0));return b[y].columns.map(C=>{let{name:D,unit:U}=T[C],N=U==="°"?`${kn(P[C],1)}°`:`${Mt(Number(P[C].toPrecision(3)))} ${U}`;return`${D} ${N}`}).join(", ")}function S(){let y=f??d;if(o.hidden=a.hidden=y===null,c.textContent=d===null?"":w(d),h.hidden=d!==null,y===null)return;o.textContent=`${i[y].name}: ${w(y)}`;let[b,T]=i[y].ends.map(x),P=Math.hypot(T[0]-b[0],T[1]-b[1]),C=Math.atan2(T[1]-b[1],T[0]-b[0]);a.style.width=`${P.toFixed(1)}px`,a.style.transform=`translate(${b[0].toFixed(1)}px, ${b[1].toFixed(1)}px) rotate(${C.toFixed(4)}rad)`}let A=y=>{y!==f&&(f=y,S())},M=y=>{d=y,l.value=y===null?"":String(y),S()};return s.addEventListener("pointermove",y=>{y.pointerType==="mouse"&&A(y.buttons?null:m(y))}),s.addEventListener("pointerleave",()=>A(null)),s.addEventListener("pointerdown",y=>{p=y.isPrimary?[y.clientX,y.clientY]:null}),s.addEventListener("pointerup",y=>{if(!p||Math.hypot(y.clientX-p[0],y.clientY-p[1])>ZE)return;let b=m(y);M(b===d?null:b)}),l.addEventListener("change",()=>M(l.value===""?null:Number(l.value))),n.onDraw(S),v("div",{className:"crease-choice"},v("label",{},`${e.creases.kind} `,l),c,h)}function jE([n,e],[t,i],[s,r]){let[o,a]=[s-t,r-i],l=Math.min(1,Math.max(0,((n-t)*o+(e-i)*a)/(o*o+a*a||1)));return Math.hypot(n-t-l*o,e-i-l*a)}var KE=[["space","play or pause"],["← →","short step back or forward"],["page down, page up","long step back or forward"],["home, end","start, end"]],JE="shift with ← → ↑ ↓",QE=[["+ −","nearer, further"],["0","reset the view"]];function Lu(n,e){let i=(n.length===1?n[0].marks:[]).map((r,o)=>[String(o+1),r.name]),s=[...KE,...i,[JE,`turn the ${e}`],...QE].map(([r,o])=>v("tr",{},v("th",{scope:"row"},r),v("td",{},o)));return v("details",{className:"keys"},v("summary",{},"Keys"),v("table",{},v("tbody",{},...s)),v("p",{},"Space and arrow keys work unless another control has the focus. All other keys work only in the player."))}var q0={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function Y0({key:n,shiftKey:e},t,i,s){if(e&&n in q0)t.turn(...q0[n]);else if(s)if(n==="+"||n==="=")t.zoom(1);else if(n==="-"||n==="−")t.zoom(-1);else if(n==="0")t.show(i);else return!1;else return!1;return!0}function Z0(n,e,t){n.addEventListener("keydown",i=>{!i.ctrlKey&&!i.metaKey&&!i.altKey&&Y0(i,e,t,!0)&&i.preventDefault()})}function Nu(n,e,t,i,s){let r={ArrowLeft:-1,ArrowRight:1,PageUp:10,PageDown:-10};function o(c){t.pause(),c()}function a(c,h){let{key:u}=c;if(Y0(c,i,s,h))return!0;if(u in r)o(()=>t.step(r[u]));else if(u===" ")t.playing?t.pause():t.play();else if(u==="Home")o(()=>t.seek(t.span.start));else if(u==="End")o(()=>t.seek(t.span.end));else if(h)if(e.length===1&&e[0].marks[Number(u)-1])o(()=>t.seekClip(0,e[0].marks[Number(u)-1].time));else return!1;else return!1;return!0}function l(c){let h=document.activeElement,u=n.contains(h);!(u||h===document.body||h===null)||c.ctrlKey||c.metaKey||c.altKey||h instanceof HTMLSelectElement||h?.dataset?.keys==="own"||c.key===" "&&/^(BUTTON|SUMMARY|A)$/.test(h?.tagName??"")||h===document.body&&/^(Home|End|PageUp|PageDown)$/.test(c.key)||a(c,u)&&c.preventDefault()}return document.addEventListener("keydown",l),()=>document.removeEventListener("keydown",l)}var j0=2.4;function il(n){let e=10**Math.floor(Math.log10(n/j0));return e*[5,2,1].find(t=>t*e<=n/j0)}function K0(n,e){let t=il(n),i=t*Math.ceil(1.25*n/t),s=[],[r,o]=[e.x,e.y].map(c=>t*Math.round(c/t));for(let c=-i;c<=i+t/2;c+=t)s.push(r+c,o-i,0,r+c,o+i,0,r-i,o+c,0,r+i,o+c,0);let a=new bn().setAttribute("position",new an(s,3)),l=new Ar(a,new js({transparent:!0,opacity:.5,depthWrite:!1}));return l.frustumCulled=!1,l}function Rf(n,e,t,i){let s=i?["marks on the time line: the states of each run, in its colour"]:[],r=n.find(({sample:a})=>a==="table"),o=r?`grid on the ${r.text}`:"grid";return v("ul",{className:"legend"},...n.filter(({sample:a})=>a!=="table").map(({sample:a,text:l})=>a==="tendon"?tT(l,e):eT(a,l)),...n.some(({sample:a})=>a==="tendon")?[v("li",{},"slack tendons sag, drawn with their rest length")]:[],v("li",{},`squares of the ${o}: ${Gs(il(t),"m")}`),...s.map(a=>v("li",{},a)))}function eT(n,e){let[t,i]=n.split(" "),s={mountain:{color:Eu},valley:{color:Tu},region:{background:tl(i)}};return v("li",{className:t==="region"?"of-region":""},Q0(t==="region"?"panel":t,s[t]??{}),e)}function tT(n,e){return Pf(n,"0",Oo,`${Mt(e.factor*e.largest_J)} ${e.unit}${e.orMore?" or more":""}`)}function Pf(n,e,t,i){let s=Q0("bar",{background:t.gradient});return v("li",{className:"energy"},`${n}: `,v("span",{className:"whole"},e,s,i))}function J0(n){let e=v("span"),t=document.createElement("canvas").getContext("2d");t.font="14px system-ui, sans-serif";let i=new Map([...new Set(n)].map(o=>[o,t.measureText(o).width])),s=[...i.keys()].reduce((o,a)=>i.get(a)>i.get(o)?a:o),r=v("span",{className:"room","aria-hidden":"true"},s);return{element:v("span",{className:"roomy"},r,e),say:o=>{e.textContent=o}}}function Q0(n,e){let t=v("span",{className:`swatch ${n}`,"aria-hidden":"true"});return Object.assign(t.style,e),t}function ex(n,e){if(!(e>n*(1+1e-6)))return 0;let[t,i]=[0,e/2];for(let s=0;s<40;s++){let r=(t+i)/2;nT(n,r)<e?t=r:i=r}return(t+i)/2}function nT(n,e){return e===0?n:Math.hypot(n,4*e)/2+n*n*Math.asinh(4*e/(n||1e-12))/(8*e)}function nx(n){let{triangles:e,faces:t,membraneLaw:i}=n.mesh,s=n.builtVertices(),r=Array.from({length:t.length},(u,d)=>tx(s,e,d)),o=new Float32Array(t.reduce((u,d)=>Math.max(u,d),0)+1),a=new Float32Array(t.length);function l(u,d){let{youngs_modulus_Pa:f,poisson_ratio:p}=i;return f/(1-p*p)*((1-p)*u+p*(u+d))}function c(u,d="strain"){o.fill(-1/0);for(let f=0;f<t.length;f++){let[p,x,m]=r[f],g=p*m-x*x;if(g<=1e-9*(p+m)**2)continue;let[_,w,S]=tx(u,e,f),A=(m*_-2*x*w+p*S)/(2*g),M=(_*S-w*w)/g,y=Math.sqrt(Math.max(A*A-M,0)),[b,T]=[(A+y-1)/2,(A-y-1)/2],P=d==="stress"?l(b,T):b;o[t[f]]=Math.max(o[t[f]],P)}for(let f=0;f<t.length;f++)a[f]=Math.max(0,o[t[f]]);return a}function h(u){let d=new Float32Array(s.length),f=0;for(let p of n.time)f=c(n.verticesAt(p,d),u).reduce((x,m)=>Math.max(x,m),f);return f}return{at:c,largest:h}}function tx(n,e,t){let[i,s,r]=[0,1,2].map(c=>3*e[3*t+c]),[o,a,l]=[0,0,0];for(let c=0;c<3;c++){let h=n[s+c]-n[i+c],u=n[r+c]-n[i+c];o+=h*h,a+=h*u,l+=u*u}return[o,a,l]}var iT=.9,ix=.4,sT=.02,rT=["crease","rim","edge"],lr=12;function If(n,e){let{mesh:t}=n,i=new Float32Array(3*t.share.length),s=new Float32Array(n.tendons),r=Math.max(0,...t.tubes.map(T=>T.radius)),[o,a]=[!1,!0].map(T=>aT(t,T)),l=sx(t.tubes.filter(T=>T.kind==="bar"),20,0),c=sx(t.tubes.filter(T=>rT.includes(T.kind)),8,.4*r),h=lT(n,2.4*r),u=uT(t.base),d=n.efforts?D0(n):null,f=n.strained?nx(n):null,p=null,x=hT(t),m=new Ln;m.add(u.object,a.object,l.object,x.object,c.object,h.object,o.object),d&&m.add(d.group);let g=oT(o.object,a.object,l.object),_=[0,0,0],w=new je;function S(T){n.verticesAt(T,i),o.pose(i),a.pose(i);for(let C of[l,c,x])C.pose(i);n.valuesAt(Is,T,s);let P=s.map(C=>e>0?C/e:0);h.pose(i,T,C=>ix+(1-ix)*Math.min(1,Math.max(0,P[C])/sT));for(let C=0;C<n.tendons;C++)Oo.at(P[C],_),h.colour(C,w.setRGB(..._,"srgb"));n.tendons&&(h.object.instanceColor.needsUpdate=!0),d?.pose(T),p&&A()}function A(){let T=f.at(i,p.quantity),P=[0,0,0];for(let C of[o,a])C.colour(D=>w.setRGB(...Cu.at(T[D]/p.largest,P),"srgb"))}function M(T,P){p=f&&T?{quantity:T,largest:P}:null;for(let C of[o,a])C.flat(p!==null),p||C.colour(D=>w.set(tl(t.regions[D])));p&&A()}function y(){for(let T of[l,c,x,u])T.paint();d?.paint(),g.children[0].material.color.set(_t("--shadow"))}function b(){for(let T of[l,c,h,x])T.object.dispose();for(let T of[o,a])T.dispose();d?.dispose(),u.dispose();for(let T of[l,c,h,x])T.object.geometry.dispose(),T.object.material.dispose();g.children[0].material.dispose()}return{group:m,shadow:g,pose:S,paint:y,sort:o.sort,vertices:i,tendons:h.object,efforts:d,strains:f,colourSheets:M,dispose:b}}function oT(...n){let e=new As({side:zn,transparent:!0,opacity:.12,depthWrite:!1,stencilWrite:!0,stencilRef:1,stencilFunc:Xd,stencilZPass:$d}),t=new Ln;for(let i of n){let s=i.isInstancedMesh?new fi(i.geometry,e,i.count):new _n(i.geometry,e);i.isInstancedMesh&&(s.instanceMatrix=i.instanceMatrix),s.frustumCulled=!1,t.add(s)}return t.scale.z=1e-5,t}function aT(n,e){let t=n.regions.flatMap((S,A)=>n.solid[S]===e?[A]:[]),i=t.flatMap(S=>n.triangles.slice(3*S,3*S+3)),s=t.length,r=new un(new Float32Array(3*i.length),3).setUsage(ja),o=new un(new Float32Array(3*i.length),3).setUsage(ja),a=new un(new Uint32Array(i.length),1).setUsage(ja);for(let S=0;S<i.length;S++)a.array[S]=S;let l=new bn;l.setAttribute("position",r),l.setAttribute("color",o),l.setIndex(a);let c=new Ts({vertexColors:!0,side:zn,flatShading:!0,transparent:!e,opacity:e?1:iT,depthWrite:e,forceSinglePass:!0});c.onBeforeCompile=S=>{S.fragmentShader=S.fragmentShader.replace("#include <color_fragment>",`#include <color_fragment>
if (!gl_FrontFacing) diffuseColor.rgb *= 0.84;`)};let h=new As({vertexColors:!0,side:zn}),u=new _n(l,c);u.frustumCulled=!1,u.renderOrder=e?0:1;let d=new je;f(S=>d.set(tl(n.regions[S])));function f(S){for(let[A,M]of t.entries()){let y=S(M);for(let b=0;b<3;b++)y.toArray(o.array,9*A+3*b)}o.needsUpdate=!0}let p=S=>{u.material=S?h:c};function x(){l.dispose(),c.dispose(),h.dispose()}function m(S){for(let A=0;A<i.length;A++)for(let M=0;M<3;M++)r.array[3*A+M]=S[3*i[A]+M];r.needsUpdate=!0}let g=new Float32Array(s),_=Array.from({length:s},(S,A)=>A);function w(S){let A=r.array;for(let M=0;M<s;M++){let y=0;for(let b=0;b<3;b++){let T=9*M+b;y+=((A[T]+A[T+3]+A[T+6])/3-S.getComponent(b))**2}g[M]=y}_.sort((M,y)=>g[y]-g[M]);for(let M=0;M<s;M++)for(let y=0;y<3;y++)a.array[3*M+y]=3*_[M]+y;a.needsUpdate=!0}return{object:u,pose:m,sort:w,colour:f,flat:p,dispose:x}}function sx(n,e,t){let i=new fi(new wi(1,1,1,e),Nr(t),n.length);i.frustumCulled=!1,o();let s=n.map(a=>[3*a.ends[0],3*a.ends[1],a.radius]);function r(a,l=()=>1){let c=i.instanceMatrix.array;for(let[h,[u,d,f]]of s.entries())ko(a,u,d,l(h)*f,c,16*h);i.instanceMatrix.needsUpdate=!0}function o(){let a={M:new je(Eu),V:new je(Tu),B:new je(_t("--bar"))};for(let[l,{crease:c,region:h}]of n.entries())i.setColorAt(l,h===void 0?a[c]:new je(E0(h)));n.length&&(i.instanceColor.needsUpdate=!0)}return{object:i,pose:r,paint:o}}function lT(n,e){let t=n.mesh.tubes.filter(l=>l.kind==="tendon"),i=new fi(new wi(1,1,1,12),Nr(e),t.length*lr);i.frustumCulled=!1;let s=new Float32Array(t.length),r=new Float32Array(3*(lr+1));function o(l,c,h){n.restLengthsAt(c,s);let u=i.instanceMatrix.array;for(let[d,{ends:f,radius:p}]of t.entries()){cT(l,3*f[0],3*f[1],s[d],r);for(let x=0;x<lr;x++)ko(r,3*x,3*x+3,h(d)*p,u,16*(d*lr+x))}i.instanceMatrix.needsUpdate=!0}function a(l,c){for(let h=0;h<lr;h++)i.setColorAt(l*lr+h,c)}return{object:i,pose:o,colour:a}}function cT(n,e,t,i,s){let r=[0,1,2].map(d=>n[t+d]-n[e+d]),o=Math.hypot(...r),a=ex(o,i),l=Math.abs(r[2])>.999*o?[1,0,0]:[0,0,-1],c=l.reduce((d,f,p)=>d+f*r[p],0)/(o*o||1),h=l.map((d,f)=>d-c*r[f]),u=Math.hypot(...h)||1;for(let d=0;d<=lr;d++){let f=d/lr,p=4*a*f*(1-f)/u;for(let x=0;x<3;x++)s[3*d+x]=n[e+x]+f*r[x]+p*h[x]}}function uT({rods:n,radius:e}){let t=new Float32Array(n.flat(2)),i=Nr(0),s=new fi(new wi(1,1,1,16),i,n.length),r=new fi(new Ao(1,16,12),i,2*n.length),o=new Ln;for(let l of[s,r])l.frustumCulled=!1,o.add(l);for(let l=0;l<n.length;l++)ko(t,6*l,6*l+3,e,s.instanceMatrix.array,16*l);for(let l=0;l<2*n.length;l++){let c=r.instanceMatrix.array;for(let h=0;h<3;h++)[c[16*l+5*h],c[16*l+12+h]]=[e,t[3*l+h]];c[16*l+15]=1}function a(){for(let l of[s,r])l.dispose(),l.geometry.dispose();i.dispose()}return{object:o,paint:()=>i.color.set(_t("--base")),dispose:a}}function hT(n){let e=new fi(new Ao(1,16,12),Nr(0),n.joints.length);e.frustumCulled=!1;let t=()=>e.material.color.set(_t("--joint"));t();function i(s){let r=e.instanceMatrix.array;for(let[o,a]of n.joints.entries()){for(let l=0;l<3;l++)r[16*o+5*l]=n.jointRadius,r[16*o+12+l]=s[3*a+l];r[16*o+15]=1}e.instanceMatrix.needsUpdate=!0}return{object:e,pose:i,paint:t}}var rx="system-ui, -apple-system, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, sans-serif";function sl(n,e,t=1,[i,s]=[0,0]){n.save(),n.scale(t,t),n.translate(i,s);for(let r of e)ox(n,r);n.restore()}function ox(n,e){if(e.shapes){n.save(),e.kind==="moved"?n.translate(e.x,e.y):(n.beginPath(),n.rect(e.x,e.y,e.width,e.height),n.clip());for(let t of e.shapes)ox(n,t);n.restore();return}if(n.globalAlpha=e.opacity??1,n.setLineDash(e.dash??[]),n.lineWidth=e.lineWidth??1,e.kind==="text"){n.font=`${e.bold?"bold ":""}${e.size??12}px ${rx}`,n.textAlign={start:"left",middle:"center",end:"right"}[e.anchor??"start"],n.fillStyle=e.fill,n.fillText(e.text,e.x,e.y);return}if(n.beginPath(),e.kind==="rect"&&n.rect(e.x,e.y,e.width,e.height),e.kind==="circle"&&n.arc(e.x,e.y,e.r,0,2*Math.PI),e.kind==="path")for(let t of ax(e.points))for(let[i,s]of t.entries())n[i?"lineTo":"moveTo"](...s);(e.fill||e.scale)&&(n.fillStyle=e.scale?dT(n,e):e.fill,n.fill()),e.stroke&&(n.strokeStyle=e.stroke,n.stroke())}function dT(n,{x:e,width:t,scale:i}){let s=n.createLinearGradient(e,0,e+t,0);for(let[r,o]of i.entries())s.addColorStop(r/(i.length-1),o);return s}function ax(n){let e=[[]];for(let t of n)t?e.at(-1).push(t):e.at(-1).length&&e.push([]);return e.filter(t=>t.length)}function ku(n,e,t,i){let s={count:0},r=[{kind:"rect",x:0,y:0,width:e,height:t,fill:"#ffffff"},...n].map(o=>Du(o,s));return[`<svg xmlns="http://www.w3.org/2000/svg" width="${Vt(e)}" height="${Vt(t)}" viewBox="0 0 ${Vt(e)} ${Vt(t)}" font-family="${rx}">`,`<title>${lx(i)}</title>`,...r,`</svg>
`].join(`
`)}function Du(n,e){if(n.kind==="svg")return`<svg ${`x="${Vt(n.x)}" y="${Vt(n.y)}" width="${Vt(n.width)}" height="${Vt(n.height)}"`} viewBox="${n.viewBox}"${n.stretched?' preserveAspectRatio="none"':""}>${n.content}</svg>`;if(n.scale){let u=`scale${++e.count}`,d=n.scale.map((f,p)=>`<stop offset="${Vt(p/(n.scale.length-1))}" stop-color="${f}"/>`);return`<linearGradient id="${u}">${d.join("")}</linearGradient>${Du({...n,scale:null,fill:`url(#${u})`},e)}`}if(n.kind==="moved")return`<g transform="translate(${Vt(n.x)} ${Vt(n.y)})">${n.shapes.map(u=>Du(u,e)).join(`
`)}</g>`;if(n.kind==="clip"){let u=`clip${++e.count}`;return`${`<clipPath id="${u}"><rect x="${Vt(n.x)}" y="${Vt(n.y)}" width="${Vt(n.width)}" height="${Vt(n.height)}"/></clipPath>`}<g clip-path="url(#${u})">${n.shapes.map(f=>Du(f,e)).join(`
`)}</g>`}let{fill:t="none",stroke:i,lineWidth:s=1,dash:r,opacity:o}=n,a=[`fill="${t}"`];i&&a.push(`stroke="${i}" stroke-width="${Vt(s)}" stroke-linejoin="round"`),r?.length&&a.push(`stroke-dasharray="${r.join(" ")}"`),o!==void 0&&o!==1&&a.push(`opacity="${o}"`);let{x:l,y:c}=n;return n.kind==="rect"?`<rect x="${Vt(l)}" y="${Vt(c)}" width="${Vt(n.width)}" height="${Vt(n.height)}" ${a.join(" ")}/>`:n.kind==="circle"?`<circle cx="${Vt(l)}" cy="${Vt(c)}" r="${Vt(n.r)}" ${a.join(" ")}/>`:n.kind==="path"?`<path d="${ax(n.points).map(d=>`M${d.map(f=>f.map(Vt).join(" ")).join("L")}`).join("")}" ${a.join(" ")}/>`:`<text ${n.turned?`transform="translate(${Vt(l)} ${Vt(c)}) rotate(-90)"`:`x="${Vt(l)}" y="${Vt(c)}"`} font-size="${n.size??12}"${n.bold?' font-weight="bold"':""} text-anchor="${n.anchor??"start"}" ${a.join(" ")}>${lx(n.text)}</text>`}var Vt=n=>String(Number(n.toFixed(2))),lx=n=>n.replace(/[&<>"]/g,e=>`&#${e.charCodeAt(0)};`);var Ou=8,fT=["fill","stroke","stroke-width","stroke-dasharray","stroke-linejoin","stroke-linecap","opacity","font-size","font-weight","paint-order","text-anchor"],pT=new Set(["fill","stroke"]);function cr(n,e,t=null){for(let i of n)i.classList.add("paper");try{let i=n.map(c=>c.getBoundingClientRect()),[s,r]=[Math.min(...i.map(c=>c.left))-Ou,Math.min(...i.map(c=>c.top))-Ou],[o,a]=[Math.max(...i.map(c=>c.right))-s+Ou,Math.max(...i.map(c=>c.bottom))-r+Ou],l=n.flatMap(c=>Nf(c,s,r,t));return{svg:ku(l,o,a,e),width:o,height:a}}finally{for(let i of n)i.classList.remove("paper")}}function Lf(n){n.classList.add("paper");try{let{left:e,top:t,width:i,height:s}=n.getBoundingClientRect();return{shapes:Nf(n,e,t,null),width:i,height:s}}finally{n.classList.remove("paper")}}function Nf(n,e,t,i){let s=getComputedStyle(n);if(s.display==="none"||s.visibility==="hidden"||i&&n.matches(i))return[];let r=n.getBoundingClientRect(),o={x:r.left-e,y:r.top-t,width:r.width,height:r.height};if(n.localName==="svg")return[{kind:"svg",...o,viewBox:n.getAttribute("viewBox"),stretched:n.getAttribute("preserveAspectRatio")==="none",content:_T(n)}];let a=[];r.width&&r.height&&a.push(...mT(s,o)),a.push(...gT(s,o));for(let l of n.childNodes)l.nodeType===Node.TEXT_NODE?a.push(...xT(l,s,e,t)):l.nodeType===Node.ELEMENT_NODE&&a.push(...Nf(l,e,t,i));return a}function mT(n,e){let t=rl(n.backgroundColor),i=n.borderTopLeftRadius==="50%"&&e.width===e.height,s=[];t.opacity>0&&!i&&s.push({kind:"rect",...e,fill:t.text,opacity:t.opacity});let r=/^linear-gradient\(to right, (.*)\)$/.exec(n.backgroundImage);return r&&s.push({kind:"rect",...e,scale:r[1].match(/rgb\([^)]*\)/g)}),i&&s.push({kind:"circle",x:e.x+e.width/2,y:e.y+e.height/2,r:e.width/2-1,stroke:rl(n.borderTopColor).text,lineWidth:parseFloat(n.borderTopWidth),...t.opacity?{fill:t.text}:{}}),s}function gT(n,{x:e,y:t,width:i,height:s}){if(n.borderTopLeftRadius==="50%")return[];let r={Top:[[e,t],[e+i,t]],Right:[[e+i,t],[e+i,t+s]],Bottom:[[e,t+s],[e+i,t+s]],Left:[[e,t],[e,t+s]]};return Object.entries(r).flatMap(([o,a])=>{let[l,c]=[n[`border${o}Style`],parseFloat(n[`border${o}Width`])];if(l==="none"||!c)return[];let h=rl(n[`border${o}Color`]);return h.opacity?[{kind:"path",points:a,stroke:h.text,lineWidth:c,opacity:h.opacity,...l==="dashed"?{dash:[2*c,c]}:{}}]:[]})}function xT(n,e,t,i){let s=parseFloat(e.fontSize),r={size:s,bold:Number(e.fontWeight)>=600,fill:rl(e.color).text},o=document.createRange(),a=[];for(let{index:l,0:c}of n.data.matchAll(/\S+/g)){o.setStart(n,l),o.setEnd(n,l+c.length);let[h]=o.getClientRects();if(!h)continue;let u=a.at(-1),d=e.writingMode==="horizontal-tb";u&&Math.abs(d?u.box.top-h.top:u.box.left-h.left)<2?(u.words.push(c),u.last=h):a.push({words:[c],box:h,last:h})}return e.writingMode==="horizontal-tb"?a.map(({words:l,box:c})=>({kind:"text",x:c.left-t,y:c.top-i+c.height/2+.35*s,text:l.join(" "),...r})):a.map(({words:l,box:c,last:h})=>({kind:"text",x:(c.left+c.right)/2-t+.35*s,y:(Math.min(c.top,h.top)+Math.max(c.bottom,h.bottom))/2-i,text:l.join(" "),anchor:"middle",turned:!0,...r}))}function _T(n){let e=n.cloneNode(!0),[t,i]=[n,e].map(s=>[...s.querySelectorAll("*")]);for(let[s,r]of t.entries()){let o=getComputedStyle(r),a=i[s];for(let{name:l}of[...a.attributes])/^(aria-|data-|class$|role$|tabindex$|style$)/.test(l)&&a.removeAttribute(l);if(!(r.localName==="g"||r.localName==="title"))for(let l of fT){let c=o.getPropertyValue(l);if(!pT.has(l))a.setAttribute(l,c);else{let{text:h,opacity:u}=c==="none"?{text:"none",opacity:1}:rl(c);a.setAttribute(l,u?h:"none"),u&&u<1&&a.setAttribute(`${l}-opacity`,u)}}}return new XMLSerializer().serializeToString(e).replace(/^<svg[^>]*>|<\/svg>$/g,"")}function rl(n){let e=(n.match(/[\d.]+(?:e-?\d+)?%?/g)??[]).map(Number);return{text:`rgb(${(n.startsWith("color(")?e.slice(0,3).map(i=>255*i):e.slice(0,3)).map(Math.round).join(",")})`,opacity:e[3]??1}}function cx(n,e,t){let i=[];return{add:s=>i.push(yT(s)),bytes:()=>vT(i,n,e,Math.round(100*t))}}function yT(n){let e=new Uint16Array(n.length/4);for(let t=0;t<e.length;t++)e[t]=n[4*t]>>3<<10|n[4*t+1]>>3<<5|n[4*t+2]>>3;return e}function vT(n,e,t,i){let{palette:s,indexOf:r}=ST(n),o=[],a=c=>o.push(c&255,c>>8);o.push(...new TextEncoder().encode("GIF89a")),a(e),a(t),o.push(247,0,0,...s),o.push(33,255,11,...new TextEncoder().encode("NETSCAPE2.0"),3,1,0,0,0);let l=null;for(let c of n){let h=Uint8Array.from(c,(d,f)=>l&&l[f]===d?255:r[d]);o.push(33,249,4,5),a(i),o.push(255,0,44);for(let d of[0,0,e,t])a(d);o.push(0,8);let u=bT(h);for(let d=0;d<u.length;d+=255){let f=Math.min(d+255,u.length);o.push(f-d);for(let p=d;p<f;p++)o.push(u[p])}o.push(0),l=c}return o.push(59),Uint8Array.from(o)}function bT(n){let e=[],[t,i]=[0,0],s=9,r=258,o=new Int32Array(1048576).fill(-1),a=c=>{for(t|=c<<i,i+=s;i>=8;)e.push(t&255),t>>>=8,i-=8};a(256);let l=n[0];for(let c=1;c<n.length;c++){let h=l<<8|n[c];if(o[h]>=0){l=o[h];continue}a(l),r<4096?(o[h]=r,r===1<<s&&s<12&&s++,r++):(a(256),o.fill(-1),[s,r]=[9,258]),l=n[c]}return a(l),a(257),i&&e.push(t&255),e}function ST(n){let e=new Uint32Array(32768);for(let o of n)for(let a=0;a<o.length;a++)e[o[a]]++;let t=[...e.keys()].filter(o=>e[o]),i=[Df(t,e)];for(;i.length<255;){let o=i.reduce((c,h)=>h.spread>c.spread?h:c);if(!o.spread)break;let a=o.colours.sort((c,h)=>Uu(c)[o.channel]-Uu(h)[o.channel]),l=a.length>>1;i.splice(i.indexOf(o),1,Df(a.slice(0,l),e),Df(a.slice(l),e))}let s=new Uint8Array(3*256),r=new Uint8Array(32**3);for(let[o,{colours:a,weight:l}]of i.entries()){for(let c=0;c<3;c++){let h=a.reduce((u,d)=>u+e[d]*Uu(d)[c],0)/l;s[3*o+c]=Math.round(h*255/31)}for(let c of a)r[c]=o}return{palette:s,indexOf:r}}var Uu=n=>[n>>10,n>>5&31,n&31];function Df(n,e){let t=n.reduce((r,o)=>r+e[o],0),i=[0,1,2].map(r=>{let o=n.map(a=>Uu(a)[r]);return o.reduce((a,l)=>Math.max(a,l))-o.reduce((a,l)=>Math.min(a,l))}),s=Math.max(...i);return{colours:n,weight:t,channel:i.indexOf(s),spread:s*s*Math.sqrt(t)}}var Of=8,ux=12.5,wT=25,MT=.6,[AT,hx,ET]=[640,1280,2400],kf=30,[Bo,TT,dx]=[10,210,24],CT=8,RT=["video/webm;codecs=vp9","video/webm;codecs=vp8","video/webm","video/mp4"];function Bu(n,e,t,i){let r=[fs("PNG","download PNG of the picture",async()=>{let o=v("canvas");await px(n,()=>n.drawSharp(ET,()=>Fu(o,n,t(),i(),n.canvas.width)));let a=await new Promise(l=>o.toBlob(l,"image/png"));ps(a,`${qn("picture")}.png`)})];if(e.seek&&e.timeAt){r.push(fx("GIF","gif",l=>IT(n,e,t,i,l)));let o=RT.find(l=>globalThis.MediaRecorder?.isTypeSupported(l)),a=o?.startsWith("video/mp4")?"MP4":"WebM";o&&HTMLCanvasElement.prototype.captureStream&&r.push(fx(a,a.toLowerCase(),l=>LT(n,e,t,i,l,o)))}return v("span",{className:"films",role:"group","aria-label":"save"},...r)}function fx(n,e,t){let i=null,s=fs(n,`download a film as ${n}`,async()=>{if(i){i.stopped=!0;return}i={stopped:!1,progress:r=>{s.textContent=`${Math.round(100*r)} %`}};try{let r=await t(i);i.stopped||ps(r,`${qn("motion")}.${e}`)}finally{i=null,s.textContent=n}});return s}async function px(n,e){let t=yf();n.paint();try{return await e()}finally{t(),n.paint()}}async function mx(n,e,t,i){let s=e.time;e.pause?.(),await px(n,async()=>{for(let r=t();r!==null;r=t())e.seek(e.timeAt(Math.min(1,r))),await PT(),i(r)}),e.seek(s)}var PT=()=>new Promise(n=>requestAnimationFrame(n));async function IT(n,e,t,i,s){let r=v("canvas"),o=Math.round(Of*ux),[a,l]=[0,null];return await mx(n,e,()=>s.stopped||a>o?null:a/o,c=>{Fu(r,n,t(),i(),AT),l??=cx(r.width,r.height,1/ux),l.add(r.getContext("2d",{willReadFrequently:!0}).getImageData(0,0,r.width,r.height).data),s.progress(c),a++}),s.stopped?null:new Blob([l.bytes()],{type:"image/gif"})}async function LT(n,e,t,i,s,r){let o=v("canvas");Fu(o,n,t(),i(),hx);let a=new MediaRecorder(o.captureStream(wT),{mimeType:r,videoBitsPerSecond:8e6}),l=[];a.ondataavailable=({data:d})=>l.push(d);let c=new Promise(d=>{a.onstop=d});a.start();let h=performance.now(),u=()=>(performance.now()-h)/1e3;return await mx(n,e,()=>s.stopped||u()>Of+MT?null:u()/Of,d=>{Fu(o,n,t(),i(),hx),s.progress(Math.min(1,d))}),a.stop(),await c,new Blob(l,{type:r.split(";")[0]})}function Fu(n,e,t,i,s){let{canvas:r,cells:o}=e,a=s/r.clientWidth,l=Math.round(a*r.clientHeight),c=Math.max(1,a),h=NT(t,i,s/c),u=Math.round(c*h.height),d=[2*Math.round(s/2),2*Math.round((l+u)/2)];(n.width!==d[0]||n.height!==d[1])&&([n.width,n.height]=d);let f=n.getContext("2d",{willReadFrequently:!0});if(f.fillStyle="#ffffff",f.fillRect(0,0,...d),f.drawImage(r,0,0,s,l),o.length>1)for(let p of o)sl(f,Lf(p).shapes,a,[p.offsetLeft,p.offsetTop]);sl(f,h.shapes,c,[0,l/c])}function NT(n,e,t){let i=[{kind:"text",x:Bo,y:20,text:n.text,bold:!0,size:14,fill:"#16191d"}],[s,r]=[n.longest?Math.max(TT,Bo+CT*n.longest+dx):Bo,0];for(let{shapes:o,width:a,height:l}of e.map(Lf))s>Bo&&s+a>t-Bo&&([s,r]=[Bo,r+kf]),i.push({kind:"moved",x:s,y:r+(kf-l)/2,shapes:o}),s+=a+dx;return{shapes:i,height:r+kf}}var DT=[{quantity:null,name:"panels"},{quantity:"strain",name:"strain",text:"largest Green strain of the membrane",value:n=>`${Mt(100*n)} %`},{quantity:"stress",name:"stress",text:"largest stress of the membrane (second Piola-Kirchhoff)",value:(n,e)=>Gs(n,e)}];function Uf(n,e,t){let i=v("li",{className:"energy",hidden:!0});e.append(i);let s=t.find(a=>a.stressed)?.mesh.membraneLaw.unit,o=DT.filter(({quantity:a})=>a!=="stress"||t.every(l=>l.stressed||!l.strained)).map(({quantity:a,name:l,text:c,value:h},u)=>{let d=v("button",{type:"button","aria-pressed":String(u===0)},l);return d.addEventListener("click",()=>{let f=n.colourSheets(a);a&&i.replaceChildren(...Pf(c,"0",Cu,h(f,s)).childNodes),i.hidden=!a;for(let p of e.querySelectorAll(".of-region"))p.hidden=!!a;for(let p of o)p.setAttribute("aria-pressed",String(p===d))}),d});return v("div",{className:"colours",role:"group","aria-label":"colour of the sheet"},"colour:",v("span",{},...o))}var kT=new G(0,1,0),Ff=[.86,.78],gx=.1,Bf=.004,xx=.035;function _x(n){let e=new As,t=new _n(new wi(Bf,Bf,gx,10),e),i=new _n(new Er(3*Bf,xx,16),e);t.position.y=-xx/2,i.position.y=gx/2;let s=new Ln;s.add(t,i),s.quaternion.setFromUnitVectors(kT,new G(...n));let r=()=>e.color.set(_t("--bar")),[o,a]=[new G,new G];function l(h,u){let d=o.copy(u).project(h).z;a.set(Ff[0],1,d).unproject(h),s.position.set(Ff[0],-1,d).unproject(h),s.scale.setScalar(a.distanceTo(s.position)),s.position.set(...Ff,d).unproject(h)}function c(){for(let h of[t,i])h.geometry.dispose();e.dispose()}return{group:s,paint:r,follow:l,dispose:c}}var yx=2,OT=.84,zu=1024,UT=Uint8Array.from({length:zu+1},(n,e)=>{let t=e/zu;return Math.round(255*(t<=.0031308?12.92*t:1.055*t**(1/2.4)-.055))}),zf=n=>UT[Math.min(zu,Math.max(0,Math.round(zu*n)))];function vx(n){let e=n.getContext("2d"),t=document.createElement("canvas"),i={frame:0,calls:0,triangles:0},s=1,r=[0,0,1,1];return{info:{render:i},setPixelRatio(o){s=o},setSize(o,a){[n.width,n.height]=[Math.floor(o*s),Math.floor(a*s)]},setScissorTest(){},setScissor(){},setViewport(...o){r=o.map(a=>a*s)},clear(){i.frame+=1,e.clearRect(0,0,n.width,n.height)},render(o,a){let[l,c]=[Math.round(r[2]*yx),Math.round(r[3]*yx)];if(l<1||c<1)return;let h=FT(o,a,l,c);[t.width,t.height]=[l,c],t.getContext("2d").putImageData(h,0,0),e.drawImage(t,r[0],n.height-r[1]-r[3],r[2],r[3])},dispose(){},forceContextLoss(){}}}function FT(n,e,t,i){let s=new ImageData(t,i),r={width:t,height:i,colours:new Uint32Array(s.data.buffer),depths:new Float32Array(t*i).fill(1/0)};n.updateMatrixWorld(),e.updateMatrixWorld();let o=BT(n),a=new dt().multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),l=[];n.traverseVisible(h=>{h.geometry&&!Vf(h)[0].stencilWrite&&l.push(h)});for(let h of l.filter(u=>u.isLineSegments))WT(h,a,r);let c={projection:a,view:e.matrixWorldInverse,perspective:e.projectionMatrix,position:e.position};for(let h of l.filter(u=>u.isMesh))VT(h,c,o,r);return s}var Vf=({material:n})=>Array.isArray(n)?n:[n];function BT(n){let e={towards:new G(0,0,1),sun:new je(0),sky:new je(0),ground:new je(0)};return n.traverse(t=>{t.isDirectionalLight&&(e.towards.copy(t.position).normalize(),e.sun.copy(t.color).multiplyScalar(t.intensity/Math.PI)),t.isHemisphereLight&&(e.sky.copy(t.color).multiplyScalar(t.intensity/Math.PI),e.ground.copy(t.groundColor).multiplyScalar(t.intensity/Math.PI))}),e}function zT(n,e,t,i,s){if(t.isMeshBasicMaterial){for(let u=0;u<3;u++)s[u]=zf(e[u]);return}let r=Math.max(0,n.dot(i.towards)),o=.5*n.y+.5,a=t.emissive&&t.emissiveIntensity?t.emissive.toArray().map(u=>u*t.emissiveIntensity):null,[l,c,h]=[i.sun,i.sky,i.ground].map(u=>[u.r,u.g,u.b]);for(let u=0;u<3;u++)s[u]=zf(e[u]*(r*l[u]+o*c[u]+(1-o)*h[u])+(a?.[u]??0))}function VT(n,e,t,i){let{geometry:s}=n,r=Vf(n),o={start:0,count:s.index?.count??s.attributes.position.count,materialIndex:0},a=Array.isArray(n.material)?s.groups:[o],l=n.isInstancedMesh?n.count:1,[c,h,u]=[new dt,new dt,new je];for(let d=0;d<l;d++){c.copy(n.matrixWorld),u.set(1,1,1),n.isInstancedMesh&&(n.getMatrixAt(d,h),c.multiply(h),n.instanceColor&&n.getColorAt(d,u));for(let f of a)GT(s,f,c,r[f.materialIndex],u,e,t,i)}}function GT(n,{start:e,count:t},i,s,r,o,a,l){let{position:c,normal:h,color:u}=n.attributes,d=h&&!s.flatShading,f=[s.color.r*r.r,s.color.g*r.g,s.color.b*r.b],p=new rt().getNormalMatrix(i),x=s.userData.nearer??0,m=new Map,g=new Gt,_=new G;function w(P){if(m.has(P))return m.get(P);_.fromBufferAttribute(c,P).applyMatrix4(i);let C=_.clone();g.set(_.x,_.y,_.z,1).applyMatrix4(o.projection);let D={place:C,x:(g.x/g.w+1)/2*l.width,y:(1-g.y/g.w)/2*l.height,depth:g.z/g.w,behind:g.w<=0,normal:d?new G().fromBufferAttribute(h,P).applyMatrix3(p).normalize():null};return x&&(_.applyMatrix4(o.view),_.addScaledVector(_.clone().normalize(),-x),g.set(_.x,_.y,_.z,1).applyMatrix4(o.perspective),D.depth=g.z/g.w),m.set(P,D),D}let[S,A,M,y]=[new G,new G,new G,new G],b=[0,0,0],T=[[0,0,0],[0,0,0],[0,0,0]];for(let P=e;P+2<e+t;P+=3){let C=[0,1,2].map(N=>n.index?n.index.getX(P+N):P+N),D=C.map(w);if(D.some(N=>N.behind))continue;S.subVectors(D[1].place,D[0].place),A.subVectors(D[2].place,D[0].place),M.crossVectors(S,A).normalize(),y.subVectors(o.position,D[0].place);let U=M.dot(y)<0;U&&M.negate();for(let N=0;N<3;N++){let z=C[N];for(let W=0;W<3;W++)b[W]=f[W]*(u?u.getComponent(z,W):1)*(U&&u&&!s.isMeshBasicMaterial?OT:1);zT(d?D[N].normal:M,b,s,a,T[N])}HT(D,T,l)}}function HT([n,e,t],i,{width:s,height:r,colours:o,depths:a}){let l=(e.x-n.x)*(t.y-n.y)-(e.y-n.y)*(t.x-n.x);if(Math.abs(l)<1e-9)return;let[c,h]=[Math.max(0,Math.floor(Math.min(n.x,e.x,t.x))),Math.min(s-1,Math.ceil(Math.max(n.x,e.x,t.x)))],[u,d]=[Math.max(0,Math.floor(Math.min(n.y,e.y,t.y))),Math.min(r-1,Math.ceil(Math.max(n.y,e.y,t.y)))],[f,p,x]=i,m=f.every((S,A)=>S===p[A]&&S===x[A]),g=4278190080|f[2]<<16|f[1]<<8|f[0],[_,w]=[(t.y-n.y)/l,(n.y-e.y)/l];for(let S=u;S<=d;S++){let[A,M]=[c+.5-n.x,S+.5-n.y],y=(A*(t.y-n.y)-M*(t.x-n.x))/l,b=(M*(e.x-n.x)-A*(e.y-n.y))/l,T=S*s+c;for(let P=c;P<=h;P++,T++,y+=_,b+=w){let C=1-y-b;if(C<0||y<0||b<0)continue;let D=C*n.depth+y*e.depth+b*t.depth;D>=a[T]||(a[T]=D,o[T]=m?g:4278190080|C*f[2]+y*p[2]+b*x[2]<<16|C*f[1]+y*p[1]+b*x[1]<<8|C*f[0]+y*p[0]+b*x[0])}}}function WT(n,e,{width:t,height:i,colours:s}){let{position:r}=n.geometry.attributes,[o]=Vf(n),[a,l,c]=[o.color.r,o.color.g,o.color.b].map(zf),h=Math.round(255*o.opacity)<<24|c<<16|l<<8|a,u=[0,1].map(()=>new Gt);for(let d=0;d+1<r.count;d+=2){for(let[m,g]of u.entries())g.set(r.getX(d+m),r.getY(d+m),r.getZ(d+m),1).applyMatrix4(n.matrixWorld).applyMatrix4(e);if(u.some(m=>m.w<=0))continue;let[f,p]=u.map(m=>[(m.x/m.w+1)/2*t,(1-m.y/m.w)/2*i]),x=Math.min(2e4,Math.ceil(Math.max(Math.abs(p[0]-f[0]),Math.abs(p[1]-f[1]))));for(let m=0;m<=x;m++){let[g,_]=[0,1].map(w=>Math.floor(f[w]+m/(x||1)*(p[w]-f[w])));g>=0&&g<t&&_>=0&&_<i&&(s[_*t+g]=h)}}}var bx=4096,$T=3.2,XT=new G(-.45,.75,1),qT=.42*Math.PI,YT=.64*Math.PI,ZT=.5,jT=.14;function ol(n,e,t,i,s){let r=v("canvas",{tabIndex:0,role:"img","aria-label":`${i} ${JT}`}),o=r.getContext("webgl2",{antialias:!0,alpha:!0,stencil:!0}),a=n.map(()=>v("div",{className:"cell"})),l=n.length>1,c=v("div",{className:l?"stage several":"stage"},r,...a);c.style.setProperty("--columns",String(n.length===4?2:Math.min(n.length,n.length>6?4:3)));let h=()=>l?Math.ceil($T*parseFloat(getComputedStyle(a[0]).fontSize)):0,u=o?new wu({canvas:r,context:o,antialias:!0,alpha:!0,stencil:!0}):vx(r);u.setScissorTest(!0);let d=W0(r,n,e,g,s),f=n.map(U=>QT(U,t(U),d)),p=0,x=!1,m=new Set;function g(){p||(p=requestAnimationFrame(w))}function _(){for(let[U,N]of f.entries())N.shape.pose(e.clipTime(U));x=!0}function w(){cancelAnimationFrame(p),p=0,x||_();let U=r.clientHeight,N=h();u.setScissor(0,0,r.clientWidth,U),u.setViewport(0,0,r.clientWidth,U),u.clear();for(let[z,W]of f.entries()){d.aim(z);let H=a[z],se=[H.offsetLeft,U-H.offsetTop-H.offsetHeight,H.offsetWidth,H.offsetHeight-N];u.setViewport(...se),u.setScissor(...se),W.light.position.copy(XT).applyQuaternion(d.camera.quaternion);let Y=d.camera.position.z>W.floor.position.z;W.floor.material.opacity=Y?ZT:jT,W.shape.shadow.visible=Y,W.shape.sort(d.camera.position),W.gravity?.follow(d.camera,d.controls.target),u.render(W.scene,d.camera)}d.aim();for(let z of m)z()}function S(){for(let U of f)U.floor.material.color.set(_t("--floor")),U.shape.paint(),U.gravity?.paint();g()}function A(){let[U,N]=[c.clientWidth,c.clientHeight];if(!U||!N)return;u.setPixelRatio(Math.min(devicePixelRatio,2,bx/Math.max(U,N))),u.setSize(U,N,!1);let z=a[0].offsetHeight-h();d.resize(a[0].offsetWidth/z,N/z),w()}function M(U,N){let z=Math.min(U/c.clientWidth,bx/Math.max(c.clientWidth,c.clientHeight));u.setPixelRatio(z),u.setSize(c.clientWidth,c.clientHeight,!1),w();let W=N();return A(),W}let y=new ResizeObserver(A);y.observe(c);let b=e.onChange(()=>{x=!1,w()}),T=sr(S);r.addEventListener("webglcontextrestored",g),S();function P(){cancelAnimationFrame(p),b(),T(),y.disconnect(),d.dispose();for(let{shape:U,floor:N,gravity:z}of f)U.dispose(),z?.dispose(),N.geometry.dispose(),N.material.dispose();u.dispose(),u.forceContextLoss(),c.remove()}function C(U){let N=U?f.reduce((z,{shape:W})=>Math.max(z,W.strains?.largest(U)??0),0):0;for(let{shape:z}of f)z.colourSheets?.(U,N||Number.MIN_VALUE);return g(),N}let D=o?null:v("p",{className:"note"},KT);return{element:c,note:D,canvas:r,cells:a,eye:d,pose:_,draw:w,drawSharp:M,paint:S,views:f,colourSheets:C,onDraw:U=>m.add(U),statistics:()=>u.info.render,dispose:P}}var KT="This browser has no WebGL: the processor draws the picture, without shadows and more slowly.",JT="Drag to turn, pinch to zoom; keys are listed below.";function QT(n,e,t){let i=K0(t.size,t.target);i.position.z=n.mesh.table_m??eC(n)-.06*t.size,e.shadow.position.z=i.position.z+.001*t.size;let s=new za("#ffffff",qT),r=new Ea;r.add(e.group,e.shadow,i,s,new Ua("#ffffff","#dde2e8",YT));let o=n.mesh.gravity&&_x(n.mesh.gravity);return o&&r.add(o.group),{shape:e,floor:i,light:s,scene:r,gravity:o}}function eC(n){let e=1/0,t=Math.max(1,Math.floor(n.time.length/200));for(let i=0;i<n.time.length;i+=t){let s=n.pointsAt(n.time[i]);for(let r=2;r<s.length;r+=3)e=Math.min(e,s[r])}return e}var tC=.3,nC=4,iC=4,Sx=[{name:"even motion",value:"even"},{name:"real time",value:1},{name:"1/2",value:1/2},{name:"1/5",value:1/5},{name:"1/10",value:1/10},{name:"1/20",value:1/20},{name:"1/50",value:1/50},{name:"1/100",value:1/100}];function wx(n,e){let t=sC(n,e),i=new Float64Array(t.length);for(let[l,c]of n.entries())rC(c,e.origins[l],t,i);for(let l=1;l<i.length;l++)i[l]+=i[l-1];let s=i[i.length-1],r=s>0?tC:1;for(let l=0;l<i.length;l++){let c=(t[l]-t[0])/(t[t.length-1]-t[0]||1);i[l]=r*c+(1-r)*(i[l]/(s||1))}let o=l=>l.drive!=="none"&&l.start-e.origins[0]<e.end&&l.end-e.origins[0]>e.start,a=n[0].stages.filter(o).length;return{seconds:e.seconds??nC+iC*a,wayAt:l=>or(t,i,l),timeAt:l=>or(i,t,l)}}function sC(n,e){let t=new Set([e.start,e.end]);for(let[i,s]of n.entries())for(let r of s.time){let o=r-e.origins[i];o>e.start&&o<e.end&&t.add(o)}return Float64Array.from(t).sort()}function rC(n,e,t,i){let s=n.pointsAt(t[0]+e).slice(),r=s.slice();for(let o=1;o<t.length;o++){n.pointsAt(t[o]+e,r);let a=0;for(let l=0;l<r.length;l+=3){let c=Math.hypot(r[l]-s[l],r[l+1]-s[l+1],r[l+2]-s[l+2]);c>a&&(a=c)}i[o]=Math.max(i[o],a),[s,r]=[r,s]}}var oC="M7 4.5v15l12-7.5z",aC="M7 5h3.5v14H7zM13.5 5H17v14h-3.5z",Gf=1e4,lC=.02;function Vu(n,e){let t=v("button",{type:"button",className:"play"}),i=v("input",{type:"range",min:0,max:Gf,step:1,"aria-label":e.span.unit?e.span.name:"time"}),s=v("div",{className:"bands","aria-hidden":"true"}),r=v("div",{className:"ticks","aria-hidden":"true"}),o=v("p",{className:n[0].along.length?"time long":"time"}),a=v("p",{className:"spoken",role:"status"}),l=v("div",{className:"states"}),c=null,h=[];function u(){n.length>1||n[0].marks===c||(c=n[0].marks,h=c.map(m=>uC(m,e)),l.replaceChildren(...h))}u();let d=v("div",{className:"transport"},v("div",{className:"line"},t,v("div",{className:"tracks"},...cC(n[0],e),v("div",{className:"track"},s,i,r))),v("div",{className:"choices"},o,l,...e.span.unit?[]:[hC(e)],...dC(e),a));t.addEventListener("click",()=>e.playing?e.pause():e.play()),i.addEventListener("input",()=>{e.pause(),e.seek(e.momentAt(i.value/Gf))});let f={},p=null,x=0;return e.onChange(()=>{u();let{span:m,stretched:g}=e;(m!==f.span||g!==f.stretched)&&fC(n,e,s,r),f={span:m,stretched:g},i.value=Math.round(Gf*e.shareAt(e.time)),i.setAttribute("aria-valuetext",Mx(n,e));let _=n.length===1?al(n[0],e.clipTime(0)):"",w=n.length===1?_&&` · ${_}`:e.span.label.replace("time",""),S=e.playing&&!e.span.unit?`, ${pC(e.slowness)}`:"";o.textContent=`${Ki(e.time,e.span)}${w}${S}${Ax(n[0],e.clipTime(0)," · ")}`;for(let[A,M]of(c??[]).entries())h[A].setAttribute("aria-pressed",String(Math.abs(M.time-e.clipTime(0))<1e-9));e.playing!==p&&(t.replaceChildren(Tl(e.playing?aC:oC)),t.setAttribute("aria-label",e.playing?"pause":"play"),p=e.playing),clearTimeout(x),e.playing||(x=setTimeout(()=>{a.textContent=Mx(n,e)},600))}),d}function cC(n,e){if(!n.along.length)return[];let t=qh("",100),i=v("span",{className:"profile-ball"}),s=v("small"),r=c=>100*e.shareAt(c),o=null,a=null;function l(c){let h=n.line(c.key,0),[u,d]=[Math.min(0,...h),Math.max(...h)];o=p=>100-100*(p-u)/(d-u||1);let f=Array.from(h,(p,x)=>`${r(n.time[x]).toFixed(2)} ${o(p).toFixed(2)}`);t.querySelector("path").setAttribute("d",`M${f.join("L")}`),s.textContent=c.name,s.classList.toggle("at-start",h[0]<h.at(-1)),a=c}return e.onChange(()=>{let[c]=n.along;c!==a&&l(c);let h=e.clipTime(0);i.style.left=`${r(h).toFixed(2)}%`,i.style.top=`${o(n.valuesAt(c.key,h)[0]).toFixed(2)}%`}),[v("div",{className:"profile","aria-hidden":"true"},t,i,s)]}function uC(n,e){let t=v("button",{type:"button",className:"state"},v("b",{},n.letter),` ${n.name}`);return t.addEventListener("click",()=>{e.pause(),e.seekClip(0,n.time)}),t}function hC(n){let e=Sx.map(({name:i,value:s})=>v("option",{value:String(s)},i)),t=v("select",{},...e);return t.addEventListener("change",()=>n.setSpeed(t.value==="even"?"even":Number(t.value))),v("label",{},"speed ",t)}function dC(n){if(n.spans.length<2)return[];let e=n.spans.map((i,s)=>v("option",{value:String(s)},i.name)),t=v("select",{},...e);return t.addEventListener("change",()=>n.setSpan(n.spans[Number(t.value)])),n.onChange(()=>{t.value=String(n.spans.indexOf(n.span))}),[v("label",{},"show ",t)]}function fC(n,e,t,i){let{span:s}=e,r=o=>Math.min(1,Math.max(0,e.shareAt(o)));t.replaceChildren(),i.replaceChildren();for(let[o,a]of n.entries()){let l=s.origins[o];for(let c of a.stages.filter(h=>h.driven&&n.length===1)){let[h,u]=[r(c.start-l),r(c.end-l)],d=v("span",{className:"band"});d.style.left=`${100*h}%`,d.style.width=`${100*(u-h)}%`,u>h&&t.append(d)}for(let c of a.marks){let h=c.time-l;if(h<s.start-1e-9||h>s.end+1e-9)continue;let[u,d]=[r(h),i.lastElementChild];if(d&&n.length===1&&u-d.at<lC){d.append(` ${c.letter}`);continue}let f=v("span",{className:"tick",at:u},n.length===1?c.letter:"");f.style.left=`${100*u}%`,n.length>1&&f.style.setProperty("--tick",`var(--line-${o%7})`),i.append(f)}}}function pC(n){return n<1.05?"real time":`${n<10?kn(n,1):Math.round(n)} times slower`}function al(n,e){let t=n.markAt(e);return t?`${t.letter} ${t.name}`:n.stageAt(e).name}function Ax(n,e,t){let i=({name:s,unit:r,key:o})=>`${t}${s} ${Mt(Number(n.valuesAt(o,e)[0].toPrecision(3)))} ${r}`;return n.along.map(i).join("")}function Mx(n,e){let t=n.map((i,s)=>{let r=e.clipTime(s);return`${n.length>1?`${i.name}: `:""}${al(i,r)||e.span.name}${Ax(i,r,", ")}${mC(i,r)}`});return`${Ki(e.time,e.span)}: ${t.join("; ")}`}function mC(n,e){let[t]=n.readings;if(!t)return"";let i=n.markAt(e)?.readings[t.name]?.mean??n.valuesAt(t.name,e),s=t.unit==="deg"?"degrees":t.unit,r=[Math.min(...i),Math.max(...i)].map(a=>kn(a,1)),o=i.length>1;return`, ${t.label}${o?"s":""} ${o?r.join(" to "):r[0]} ${s}`}function ur(n,e,t,{energy:i,legend:s,text:r,whole:o},a,l=e.length>1||!!a){let c=ol(e,t,x=>If(x,i.largest_J),r,a),h=v("div",{className:"picture"},c.element,...c.note?[c.note]:[],Hu(c.eye,l?o:null));e.length===1&&xC(c.cells[0],e[0],t);let u=[Rf(s,i,c.eye.size,e.length>1?o:null)];e.some(x=>x.strained)&&u.unshift(Uf(c,u[0],e)),e.length===1&&e[0].efforts?.drives.length&&_C(u.at(-1),e[0],t),e.length>1&&e.some(x=>x.efforts?.drives.some(m=>m.arrow))&&u.at(-1).append(v("li",{className:"effort"},Tx(),"torque or force of a drive, while it acts"));let d=e.length===1&&e[0].creases?[X0(c,e[0],t)]:[];n.replaceChildren(h,Vu(e,t),...d,...u,Lu(e,o)),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label",`the moving ${o}`),Ex(n,c,t,()=>gC(e,t));let f=Nu(n,e,t,c.eye,kr[0]);function p(){t.pause(),f(),c.dispose(),n.replaceChildren()}return{stage:c,dispose:p}}function Gu(n,e,t,{energy:i,legend:s,text:r,whole:o},a){let l=ol(e,t,u=>If(u,i.largest_J),r,a),c=v("div",{className:"picture"},l.element,...l.note?[l.note]:[],Hu(l.eye,null,!a)),h=[Rf(s,{...i,orMore:!0},l.eye.size,null)];return e.some(u=>u.strained)&&h.unshift(Uf(l,h[0],e)),n.replaceChildren(c,...h),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label",`the ${o} as set by the sliders`),Ex(n,l,t,()=>({text:"",longest:0})),Z0(n,l.eye,kr[0]),{stage:l}}function Ex(n,e,t,i){let s=()=>[...n.querySelectorAll(".legend .energy:not([hidden])")];n.querySelector(".views").prepend(Bu(e,t,i,s))}function gC(n,e){let{span:t}=e,[i]=n,s=n.length===1?`${al(i,e.clipTime(0))}, `:"",r=n.length===1?[...i.stages.map(({name:c})=>c),...i.marks.map(({letter:c,name:h})=>`${c} ${h}`)]:[],o=c=>Math.max(0,...c.map(h=>h.length)),a=`${s}${Ki(e.time,t)}`,l=[t.start,t.end].map(c=>Ki(c,t));return{text:a,longest:Math.max(a.length,o(r)+2+o(l))}}function xC(n,e,t){let i=v("p",{className:"now","aria-hidden":"true"});n.append(i),t.onChange(()=>{i.textContent=al(e,t.clipTime(0)),i.hidden=!i.textContent})}function Tx(){return v("span",{className:"swatch arrow","aria-hidden":"true"})}function _C(n,e,t){let i=e.efforts.drives.some(o=>o.arrow),s=o=>N0(e.efforts,o,Mt).join("; ")||"no drive acts now",r=J0(Array.from(e.time,s));n.append(v("li",{className:"effort"},...i?[Tx()]:[],r.element)),t.onChange(()=>r.say(s(t.clipTime(0))))}function Hu(n,e,t=!0){let i=kr.map(l=>fs(l.name,`${l.name}: view ${l.text}`,()=>n.show(l))),s=[["←","turn left",[-1,0]],["→","turn right",[1,0]],["↑","turn up",[0,1]],["↓","turn down",[0,-1]]].map(([l,c,h])=>fs(l,c,()=>n.turn(...h))),r=(l,c,h)=>{let u=fs(l,c,()=>{n.choose({[h]:!n.look[h]}),u.setAttribute("aria-pressed",String(n.look[h]))});return u.setAttribute("aria-pressed",String(n.look[h])),u},o=[...t?[r("follow","follow: keep the picture filled as the structure moves","following")]:[],...e?[r("one scale",`one scale: draw all ${e}s at the same scale`,"oneScale")]:[]],a=[fs("+","nearer",()=>n.zoom(1)),fs("−","further",()=>n.zoom(-1))];return v("div",{className:"views",role:"group","aria-label":"view"},...o.length?[v("span",{},...o)]:[],v("span",{},...i),v("span",{className:"turns"},...s),v("span",{},...a))}var yC=4,vC={deg:.05};function hr(n,e,t,i,s=0,r=!1){let{heading:o,names:a}=e.mesh.parts,l=e.readings.map(w=>({name:w.name,title:w.row,parts:w.parts,text:S=>Hf(S,w.unit),ofState:S=>S.readings[w.name]&&bC(S.readings[w.name],w.unit)})),c=w=>Mt(i.factor*w);e.tendons&&l.push({name:Is,title:`tendon energy (${i.unit})`,parts:e.mesh.tendonParts,text:c,ofState:w=>w.tendonEnergy_J?.map(c)});let h=l.map(()=>a.map(()=>v("td"))),u=v("caption"),d=l.map(w=>w.title),f=a.length>yC,[p,x]=f?[d,a]:[a,d],m=v("tr",{},o?v("th",{scope:"col"},o):v("td"),...p.map(w=>v("th",{scope:"col"},w))),g=x.map((w,S)=>v("tr",{},v("th",{scope:"row"},w),...f?h.map(A=>A[S]):h[S])),_=v("table",{className:"numbers"},u,v("thead",{},m),v("tbody",{},...g));return n.replaceChildren(v("div",{className:"table"},_)),n.classList.add("readout"),t.onChange(()=>{let w=t.clipTime(s),S=e.markAt(w),A=S?`, ${S.name}${S.tendonEnergy_J?" (means)":""}`:"",M=r?`${e.name}: `:"",y=o?`every ${o}`:"all values";u.textContent=`${Nt(`${M}${y}`)} at ${Ki(t.time,t.span)}${A}`;for(let[b,T]of l.entries()){let P=S&&T.ofState(S)||Array.from(e.valuesAt(T.name,w),T.text);for(let[C,D]of T.parts.entries())h[b][D].textContent=P[C]}})}function Hf(n,e){return e==="deg"?kn(n,1):Mt(n)}function bC({mean:n,swing:e},t){return n.map((i,s)=>{let r=e[s]>(vC[t]??.005*Math.abs(i));return`${Hf(i,t)}${r?` ± ${Hf(e[s],t)}`:""}`})}var SC=0;function zo(n=document){let e=new ResizeObserver(t=>{for(let{target:i}of t)if(Cx(i),i.scrollWidth>i.clientWidth||i.scrollHeight>i.clientHeight)wC(i);else for(let s of["tabindex","role","aria-label","aria-labelledby"])i.removeAttribute(s)});for(let t of n.querySelectorAll(".table"))e.observe(t),t.addEventListener("scroll",()=>Cx(t),{passive:!0})}function Cx(n){let e=Math.abs(n.scrollLeft);n.classList.toggle("more-left",e>1),n.classList.toggle("more-right",e+n.clientWidth<n.scrollWidth-1)}function wC(n){let{caption:e}=n.querySelector("table");if(n.tabIndex=0,n.setAttribute("role","group"),!e){let t=[...n.querySelectorAll("thead th")].map(i=>i.textContent);return n.setAttribute("aria-label",t.join(", ")||"table")}return e.id||=`caption-${++SC}`,n.setAttribute("aria-labelledby",e.id)}function MC(n,e){let t=n.design.text.split(`
`);for(let{key:i,unit:s,factor:r,line:o}of n.knobs)i in e&&(t[o.number]=`${o.before}${Px(e[i],s,r)}${o.after}`);return t.join(`
`)}function Rx({knobs:n},e,t){let{unit:i,factor:s}=n.find(r=>r.key===e);return Px(t,i,s)}function Px(n,e,t){return`${Number((t*n).toPrecision(12))} ${e}`}function Ix(n){let e=v("a",{className:"button",download:"design.toml"},"This setting as a design file"),t=v("code"),i=v("p",{className:"note"},"This page does not check the energy balance; a run of the file does."),s=v("div",{className:"setting"},e,v("pre",{},t),i);function r(o){let a=new TextEncoder().encode(MC(n,o));e.href=`data:application/toml;base64,${btoa(String.fromCharCode(...a))}`,t.textContent="forficula run design.toml"}return r({}),{element:s,refresh:r}}var Lx=[["←","left","ArrowLeft",[-1,0]],["↑","up","ArrowUp",[0,1]],["↓","down","ArrowDown",[0,-1]],["→","right","ArrowRight",[1,0]]],dr=Object.fromEntries(Lx.map(([,,n,e])=>[n,e])),Wu=n=>v("select",{},...n.map(([e,t])=>v("option",{value:t},e)));function $u(n,{clicked:e,pressed:t}){let i=Lx.map(([r,o,a])=>{let l=v("button",{type:"button",title:`${n} ${o}`,"aria-label":`${n} ${o}`,"data-way":a},r);return l.addEventListener("click",()=>e(a)),l}),s=v("span",{className:"pad",role:"group","aria-label":`${n} in the plane of the picture`},...i);return s.addEventListener("keydown",r=>{!(r.key in dr)||r.shiftKey||r.ctrlKey||r.metaKey||r.altKey||(r.preventDefault(),r.stopPropagation(),t(r.key))}),s}var AC=500,Nx=[["a little",.1],["half",.5],["as strong as its drives",1]];function Dx(n,e,t,i,s){let r=Wu(t.map((_,w)=>[_,w]).filter(([,_])=>e.movable[_])),o=v("select",{},...Nx.map(([_,w])=>v("option",{value:w,selected:w===Nx[0][1]},_))),a=v("span",{className:"note",role:"status"}),l=$u("push",{clicked:g,pressed:m}),c=v("p",{className:"note"},"On these buttons, arrow keys push while they are held. Pressing a button pushes for half a second."),h=v("details",{className:"push-keys"},v("summary",{},"Push without a pointer"),v("div",{className:"choices"},v("label",{},"point ",r),v("label",{},"force ",o),l,a),c),u=EC(n,e,()=>Number(r.value),h),d=new Set,f=0;function p(){clearTimeout(f);let[_,w]=[0,1].map(M=>[...d].reduce((y,b)=>y+dr[b][M],0));if(!_&&!w){a.textContent="",s(0,null);return}let{camera:S}=n.eye,A=new G().setFromMatrixColumn(S.matrixWorld,0).multiplyScalar(_);A.addScaledVector(new G().setFromMatrixColumn(S.matrixWorld,1),w).setLength(Number(o.value)*i),a.textContent=`${r.selectedOptions[0].text} pushed with ${Mt(A.length())} N`,s(Number(r.value),A.toArray())}function x(){d.size&&(d.clear(),p())}function m(_){d.has(_)||(d.add(_),p())}function g(_){d.clear(),d.add(_),p(),f=setTimeout(x,AC)}return l.addEventListener("keyup",({key:_})=>{d.delete(_)&&p()}),l.addEventListener("focusout",x),r.addEventListener("change",()=>{x(),u()}),h.addEventListener("toggle",u),h}function EC(n,e,t,i){let s="http://www.w3.org/2000/svg",r=document.createElementNS(s,"svg"),o=document.createElementNS(s,"circle");o.setAttribute("r","9"),r.classList.add("push"),r.setAttribute("aria-hidden","true"),r.append(o),n.element.append(r);let a=new G;function l(){if(r.style.display=i.open?"":"none",!i.open)return;let[c,h]=Fo(a.fromArray(e.frame.points,3*t()),n.eye.camera,n.canvas);o.setAttribute("cx",c),o.setAttribute("cy",h)}return e.clock.onChange(l),n.eye.controls.addEventListener("change",l),l(),l}var TC=22;function Xu(n,{points:e,movable:t,between:i=()=>null,moved:s,left:r}){let{canvas:o,eye:a}=n,l=document.createElementNS("http://www.w3.org/2000/svg","line"),c=document.createElementNS("http://www.w3.org/2000/svg","svg");c.classList.add("push"),c.setAttribute("aria-hidden","true"),c.append(l);let h=v("p",{className:"pushed","aria-hidden":"true"});n.element.append(c,h),c.style.display="none";let[u,d]=[new G,new G],f=null,p=null;function x(y){d.set(0,0,0);for(let[b,T]of y)d.addScaledVector(u.fromArray(e(),3*b),T);return d}function m(y){return Fo(x(y),a.camera,o)}function g(y){let b=o.getBoundingClientRect();return[y.clientX-b.left,y.clientY-b.top]}function _([y,b]){let T={place:null,away:TC};for(let P=0;P<t.length;P++){if(!t[P])continue;let C=[[P,1]],[D,U]=m(C),N=Math.hypot(D-y,U-b);N<T.away&&(T={place:C,away:N})}return T.place}let w=([y,b])=>[2*y/o.clientWidth-1,1-2*b/o.clientHeight],S=y=>_(g(y))??i(...w(g(y)));function A(){if(!f)return;let y=m(f);for(let[b,T]of[["x1",y[0]],["y1",y[1]],["x2",p[0]],["y2",p[1]]])l.setAttribute(b,T);c.style.display=""}o.addEventListener("pointerdown",y=>{f=y.button===0?S(y):null,f&&(a.controls.enabled=!1,o.setPointerCapture(y.pointerId),y.stopImmediatePropagation())},{capture:!0}),o.addEventListener("pointermove",y=>{if(!f){o.classList.toggle("grip",S(y)!==null);return}p=g(y);let b=x(f).clone(),T=b.clone().project(a.camera).z;s(f,b,new G(...w(p),T).unproject(a.camera)),A()});let M=()=>{f&&(f=null,a.controls.enabled=!0,c.style.display="none",h.textContent="",r())};return o.addEventListener("pointerup",M),o.addEventListener("pointercancel",M),n.onDraw(A),{say:y=>h.textContent=y}}var CC=.25;function kx(n,e,t,i,s){let{say:r}=Xu(n,{points:()=>e.frame.points,movable:e.movable,moved([[o]],a,l){let c=l.sub(a).multiplyScalar(i/(CC*t)).clampLength(0,i);s(o,c.toArray()),r(`pushed with ${Mt(c.length())} N`)},left:()=>s(0,null)})}var ll=200,RC=20,PC=3;function Ox(n,e,t){let i=n.map(o=>IC(o,e,t)),s=v("button",{type:"button",disabled:!0},`Reset all to ${e}`);s.addEventListener("click",()=>i.forEach(o=>o.reset()));let r=v("div",{className:"sliders",role:"group","aria-label":"values to change"});return r.append(...i.map(o=>o.element),s),{element:r,set(o){for(let a of i)a.put(o[a.knob.key]??a.knob.value)},get changes(){let o=i.filter(a=>a.value!==a.knob.value);return Object.fromEntries(o.map(a=>[a.knob.key,a.value]))},refresh(){s.disabled=i.every(o=>o.value===o.knob.value)}}}function IC(n,e,t){let{key:i,title:s,unit:r,factor:o,lowest:a,highest:l}=n,c=a>0&&l/a>=RC,h=A=>c?a*(l/a)**A:a+A*(l-a),u=A=>c?Math.log(A/a)/Math.log(l/a):(A-a)/(l-a),d=Math.round(ll*u(n.value)),f=Nt(i.replace("protocol.","").replace("youngs","Young's").replaceAll(/[._]/g," ")),p=v("input",{type:"range",min:0,max:ll,step:1,"aria-label":f,"aria-description":s}),x=v("output"),m=v("span",{className:"home",title:`in ${e}`,"aria-hidden":"true"});m.style.left=`${100*d/ll}%`,p.dataset.keys="own";let g=n.value;function _(){let A=`${Mt(o*g)} ${r.replaceAll("^2","²").replaceAll("^3","³")}`;x.textContent=A,p.setAttribute("aria-valuetext",g===n.value?`${A}, as in ${e}`:A),S.classList.toggle("changed",g!==n.value)}function w(A){g=A,p.value=Math.round(ll*u(g)),_(),t(i,g)}p.addEventListener("input",()=>{let A=Number(p.value);g=A===d?n.value:Number((o*h(A/ll)).toPrecision(PC))/o,_(),t(i,g)});let S=v("label",{className:"slider",title:`${i}: ${s}`},v("span",{className:"name"},f),x,v("span",{className:"rail"},p,m));return p.value=d,_(),{element:S,knob:n,get value(){return g},put:w,reset:()=>w(n.value)}}var LC=[["real time",1],["1/2",.5],["1/5",.2],["1/20",.05],["1/100",.01]],NC=.2,qu=1.4,DC="Values were changed, or it was pushed, during the motion, which no run of a design file repeats. “Whole protocol” runs these settings from the start.",kC=1e-15;async function Vo(n,e,t,i,{look:s,pace:r=NC,set:o}={}){let a=JSON.parse(t),l={frame:null,engine:null,pace:r},c=await i(t,b=>M(b)),h=$0(n,a,c.first),u=v("p",{className:"verdict",role:"status"}),d=v("p",{className:"note"}),f=v("p",{className:"time"}),p=v("p",{className:"account"}),x=v("div"),m=v("div"),g=Ix(a),_=Ox(a.knobs,e.kind==="bench"?"the design":"this run",(b,T)=>{c.send({act:"set",values:{[b]:T}}),_.refresh(),g.refresh(_.changes),o?.(b,Rx(a,b,T))}),w=UC(a,c,l,()=>{u.textContent="",d.textContent=""}),S=a.motors.every(b=>b.kind==="torque")?"torques":"drives",A=null;function M(b){if(b.said==="refused"){u.textContent=`The simulator stopped: ${b.why}.`;return}b.said==="frame"&&y(b.frame)}function y(b){l.frame=b,h.show(b),f.textContent=`${Ki(b.time_s,{start:0,end:Math.max(1,b.time_s)})}${FC(b,a.protocol)}`;let T=b.energies_J.reduce((N,z)=>N+z,0),P=b.works_J.reduce((N,z)=>N+z,0),C=[...n.tendons?[`tendon energy ${Wf(T)}`]:[],`work of the ${S} ${Wf(P)}`];p.textContent=C.join(" · ");let D=b.stageNumber===null?b.ended:null,U=D&&JSON.stringify([D.verdict,...D.stages.map(N=>N.end_s)]);U!==A&&(u.textContent=D?BC(D,e.whole,a.texts.outcome):"",d.textContent=[D?.advice,D&&b.meddled&&DC].filter(Boolean).join(" ")),A=U}return l.element=v("div",{className:"trial"},v("div",{className:"head"},v("div",{className:"choices"},...w),v("div",{className:"live-facts"},f,p),u,d),x,v("div",{className:"hands"},_.element,...o?[]:[g.element]),m),l.begin=()=>{let b=s??{...ar(),following:!1,closer:e.kind==="bench"?qu:1},{stage:T}=Gu(x,[h.clip],h.clock,{...e,text:`${e.shape}, live.`},b);if(l.stage=T,hr(m,h.clip,h.clock,e.energy),zo(l.element),T){h.movable=a.anchors.bodies.map(D=>D>0);let P=OC(a,n.mesh.span_m),C=(D,U)=>c.send({act:"push",point:D,force:U});kx(T,h,n.mesh.span_m,P,C),x.querySelector(".picture").after(Dx(T,h,a.anchors.names,P,C))}y(c.first),c.send({act:"pace",value:l.pace}),c.send({act:"restart",through:!1}),e.kind!=="bench"&&w[0].focus({preventScroll:!0})},l.leave=()=>l.stage?.dispose(),Object.assign(l,{engine:c,live:h,sliders:_,design:g,own:a})}function OC({protocol:n,motors:e},t){let i=n.drives.map(({strength:s,torques:r})=>{let o=e[r.findIndex(a=>a!==0)];return o?.kind==="torque"?Math.abs(s)/t:o?.kind==="force"?Math.abs(s):0});return Math.max(...i)||1}function UC({protocol:n},e,t,i){let s=(a,l,c)=>{let h=v("button",{type:"button",title:c});return h.append(a),h.addEventListener("click",()=>{i(),e.send(l)}),h},r=n.stages.flatMap(({name:a,drives:l},c)=>{if(!l.length)return[];let h=n.stages.findIndex((d,f)=>f>c&&d.drives.length>0),u=(h<0?n.stages.length:h)-1;return[s(Nt(a),{act:"stages",from:c,to:u},`the stage "${a}" of the protocol, and what follows without a drive`)]}),o=v("select",{},...LC.map(([a,l])=>v("option",{value:l,selected:l===t.pace},a)));return o.addEventListener("change",()=>{t.pace=Number(o.value),e.send({act:"pace",value:t.pace})}),[s("Start again",{act:"restart",through:!1},"from the start of the run"),...r,s("Release",{act:"release"},"without any drive"),s("Whole protocol",{act:"restart",through:!0},"all stages, as in the run"),v("label",{},"speed ",o)]}function FC({stage:n,stageNumber:e,running:t,ended:i},{stages:s}){let r=n&&!s[e].drives.length&&i?.stages.at(-1),a=r&&r.goal_s!==null&&s.find(({name:l})=>l===r.name).drives.length?`, ${r.name} reached its goal in ${Gs(r.goal_s-r.start_s,"s")}`:"";return n?` · ${n}${a}`:t?" · no drive acts":" · at rest"}function BC({status:n,verdict:e,transitions:t},i,s){let r=t.filter(({took:o})=>o?.succeeded&&o.time_s!==null).map(({words:o,took:a})=>Yh(s.transition,{did:o.did||o.done,time:Gs(a.time_s,"s"),work:Wf(a.work_J)}));return r.length?Yh(s[e==="reached"?"reached":"missed"],{whole:i,transitions:r.join(s.then),status:n}):`${Nt(n)}.`}var Wf=n=>Gs(Math.abs(n)<kC?0:n,"J");function Yu(n,e,t,i,s=null){if(!n)return null;let r={panel:null,failed:"",start:null},o=document.getElementById("live").textContent,a=v("button",{type:"button",className:"try"},"Try it"),l=v("p",{className:"note"});l.textContent=`Move this ${t.whole} yourself: change values, switch drives, release it, push it. The simulator runs in this page.`,n.append(v("div",{className:"offer"},a,l));function c(u){r.failed=u,a.disabled=!0;let d="To drag its vertices, open the design in the workbench, with the command forficula open.",f=`A page cannot simulate the motion in time of this ${t.whole}: ${u}.`;if(l.textContent=`${s?`A slider folds this ${t.whole} along its quasi-static path. `:""}${d} ${f}`,!s)return;let p=v("button",{type:"button",className:"try"},"Fold it slowly");p.addEventListener("click",s),a.replaceWith(p)}let h=JSON.parse(o.startsWith('{"refused"')?o:"null");return h!==null?c(h.refused):Ru()||c("this page was written without the engine"),r.start=async()=>{if(!a.disabled){a.disabled=!0,l.setAttribute("role","status"),l.textContent="Starting the simulator …",i();try{r.panel=await Vo(e,t,o,Uo),n.replaceChildren(v("h2",{},"Try it"),r.panel.element),r.panel.begin()}catch(u){c(u.message)}}},a.addEventListener("click",async()=>{await r.start(),r.failed||n.scrollIntoView({block:"start"})}),r}function Ux(n){let e=Kn(n.clips[0]),t=Yu(document.getElementById("try"),e,n,()=>{});return t.start(),{clips:[e],trial:t}}var zC=200;function Bi(n,e){let t=new Set,i=e[0].start,s=e[0],r="even",o=!1,a=0,l=0,c=new Map;function h(){return c.has(s)||c.set(s,wx(n,s)),c.get(s)}let u=()=>r==="even"&&s.whole;function d(_){return u()?h().wayAt(_):(_-s.start)/(s.end-s.start||1)}function f(_){return u()?h().timeAt(_):s.start+_*(s.end-s.start)}function p(){l||(l=requestAnimationFrame(x))}function x(_){if(l=0,o){let w=Math.min((_-a)/1e3,.1);a=_,m(w),l=requestAnimationFrame(x)}for(let w of t)w()}function m(_){r==="even"?i=h().timeAt(Math.min(1,h().wayAt(i)+_/h().seconds)):i=Math.min(s.end,i+r*_),i>=s.end&&(o=!1)}function g(_){i=Math.min(s.end,Math.max(s.start,_)),p()}return{get time(){return i},get span(){return s},get speed(){return r},get playing(){return o},spans:e,clipTime:(_,w=i)=>Math.min(n[_].end,Math.max(n[_].start,w+s.origins[_])),get stretched(){return u()},shareAt:d,momentAt:f,wayAt:_=>h().wayAt(_),timeAt:_=>h().timeAt(_),get slowness(){if(r!=="even")return 1/r;let _=h().wayAt(i),[w,S]=[Math.max(0,_-5e-4),Math.min(1,_+5e-4)];return(S-w)*h().seconds/(h().timeAt(S)-h().timeAt(w)||1e-12)},onChange(_){return t.add(_),p(),()=>t.delete(_)},seek:g,seekClip(_,w){(w<s.start+s.origins[_]||w>s.end+s.origins[_])&&(s=e.find(S=>w>=S.start+S.origins[_]&&w<=S.end+S.origins[_])??e[0]),g(w-s.origins[_])},step:_=>g(f(d(i)+_/zC)),play(){i>=s.end&&(i=s.start),o=!0,a=performance.now(),p()},pause(){o=!1,p()},setSpeed(_){r=_,p()},setSpan(_){s=_,g(i<s.start||i>s.end?s.start:i)},redraw:p}}var VC="uplot",GC="u-hz",HC="u-vt",WC="u-title",$C="u-wrap",XC="u-under",qC="u-over",YC="u-axis",Fr="u-off",ZC="u-select",jC="u-cursor-x",KC="u-cursor-y",JC="u-cursor-pt",QC="u-legend",eR="u-live",tR="u-inline",nR="u-series",iR="u-marker",Fx="u-label",sR="u-value",ul="width",hl="height";var Bx="bottom",Go="left",$f="right",lp="#000",zx=lp+"0",Xf="mousemove",Vx="mousedown",qf="mouseup",Gx="mouseenter",Hx="mouseleave",Wx="dblclick",rR="resize",oR="scroll",$x="change",Qu="dppxchange",cp="--",Zo=typeof window<"u",Jf=Zo?document:null,Wo=Zo?window:null,aR=Zo?navigator:null,It,Zu;function Qf(){let n=devicePixelRatio;It!=n&&(It=n,Zu&&tp($x,Zu,Qf),Zu=matchMedia(`(min-resolution: ${It-.001}dppx) and (max-resolution: ${It+.001}dppx)`),Br($x,Zu,Qf),Wo.dispatchEvent(new CustomEvent(Qu)))}function mi(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function ep(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Jt(n,e,t){n.style[e]=t+"px"}function zi(n,e,t,i){let s=Jf.createElement(n);return e!=null&&mi(s,e),t?.insertBefore(s,i),s}function Ai(n,e){return zi("div",n,e)}var Xx=new WeakMap;function os(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=Xx.get(n);r!=o&&(n.style.transform=r,Xx.set(n,r),e<0||t<0||e>i||t>s?mi(n,Fr):ep(n,Fr))}var qx=new WeakMap;function Yx(n,e,t){let i=e+t,s=qx.get(n);i!=s&&(qx.set(n,i),n.style.background=e,n.style.borderColor=t)}var Zx=new WeakMap;function jx(n,e,t,i){let s=e+""+t,r=Zx.get(n);s!=r&&(Zx.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var up={passive:!0},lR={...up,capture:!0};function Br(n,e,t,i){e.addEventListener(n,t,i?lR:up)}function tp(n,e,t,i){e.removeEventListener(n,t,up)}Zo&&Qf();function Vi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:gi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function M_(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var A_=n=>n!=null,E_=n=>n!=null&&n>0,nh=M_(A_),cR=M_(E_);function uR(n,e,t,i=0,s=!1){let r=s?cR:nh,o=s?E_:A_;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let h=n[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Ht,l??-Ht]}function ih(n,e,t,i){let s=Qx(n),r=Qx(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Ls:T_,a=s==1?gi:Ei,l=r==1?Ei:gi,c=a(o(En(n))),h=l(o(En(e))),u=$o(t,c),d=$o(t,h);return t==10&&(c<0&&(u=Wt(u,-c)),h<0&&(d=Wt(d,-h))),i||t==2?(n=u*s,e=d*r):(n=I_(n,u),e=sh(e,d)),[n,e]}function hp(n,e,t,i){let s=ih(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var dp=.1,Kx={mode:3,pad:dp},fl={pad:0,soft:null,mode:0},hR={min:fl,max:fl};function eh(n,e,t,i){return rh(t)?Jx(n,e,t):(fl.pad=t,fl.soft=i?0:null,fl.mode=i?3:0,Jx(n,e,hR))}function Ct(n,e){return n??e}function dR(n,e,t){for(e=Ct(e,0),t=Ct(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function Jx(n,e,t){let i=t.min,s=t.max,r=Ct(i.pad,0),o=Ct(s.pad,0),a=Ct(i.hard,-Ht),l=Ct(s.hard,Ht),c=Ct(i.soft,Ht),h=Ct(s.soft,-Ht),u=Ct(i.mode,0),d=Ct(s.mode,0),f=e-n,p=Ls(f),x=Jn(En(n),En(e)),m=Ls(x),g=En(m-p);(f<1e-24||g>10)&&(f=0,(n==0||e==0)&&(f=1e-24,u==2&&c!=Ht&&(r=0),d==2&&h!=-Ht&&(o=0)));let _=f||x||1e3,w=Ls(_),S=$o(10,gi(w)),A=_*(f==0?n==0?.1:1:r),M=Wt(I_(n-A,S/10),24),y=n>=c&&(u==1||u==3&&M<=c||u==2&&M>=c)?c:Ht,b=Jn(a,M<y&&n>=y?y:Gi(y,M)),T=_*(f==0?e==0?.1:1:o),P=Wt(sh(e+T,S/10),24),C=e<=h&&(d==1||d==3&&P>=h||d==2&&P<=h)?h:-Ht,D=Gi(l,P>C&&e<=C?C:Jn(C,P));return b==D&&b==0&&(D=100),[b,D]}var fR=new Intl.NumberFormat(Zo?aR.language:"en-US"),fp=n=>fR.format(n),xi=Math,Ju=xi.PI,En=xi.abs,gi=xi.floor,An=xi.round,Ei=xi.ceil,Gi=xi.min,Jn=xi.max,$o=xi.pow,Qx=xi.sign,Ls=xi.log10,T_=xi.log2,pR=(n,e=1)=>xi.sinh(n)*e,Yf=(n,e=1)=>xi.asinh(n/e),Ht=1/0;function e_(n){return(Ls((n^n>>31)-(n>>31))|0)+1}function np(n,e,t){return Gi(Jn(n,e),t)}function C_(n){return typeof n=="function"}function wt(n){return C_(n)?n:()=>n}var mR=()=>{},R_=n=>n,P_=(n,e)=>e,gR=n=>null,t_=n=>!0,n_=(n,e)=>n==e,xR=/\.\d*?(?=9{6,}|0{6,})/gm,zr=n=>{if(N_(n)||pr.has(n))return n;let e=`${n}`,t=e.match(xR);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${zr(s)}e${r}`}return Wt(n,i)};function Or(n,e){return zr(Wt(zr(n/e))*e)}function sh(n,e){return zr(Ei(zr(n/e))*e)}function I_(n,e){return zr(gi(zr(n/e))*e)}function Wt(n,e=0){if(N_(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return An(i)/t}var pr=new Map;function L_(n){return((""+n).split(".")[1]||"").length}function ml(n,e,t,i){let s=[],r=i.map(L_);for(let o=e;o<t;o++){let a=En(o),l=Wt($o(n,o),a);for(let c=0;c<i.length;c++){let h=n==10?+`${i[c]}e${o}`:i[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?h:Wt(h,u);s.push(d),pr.set(d,u)}}return s}var pl={},pp=[],Xo=[null,null],fr=Array.isArray,N_=Number.isInteger,_R=n=>n===void 0;function i_(n){return typeof n=="string"}function rh(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function yR(n){return n!=null&&typeof n=="object"}var vR=Object.getPrototypeOf(Uint8Array),D_="__proto__";function qo(n,e=rh){let t;if(fr(n)){let i=n.find(s=>s!=null);if(fr(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=qo(n[s],e)}else t=n.slice()}else if(n instanceof vR)t=n.slice();else if(e(n)){t={};for(let i in n)i!=D_&&(t[i]=qo(n[i],e))}else t=n;return t}function yn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=D_&&(rh(n[s])?yn(n[s],qo(i[s])):n[s]=qo(i[s]))}return n}var bR=0,SR=1,wR=2;function MR(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function AR(n,e){if(CR(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return RR(o[0])||(o=TR(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),d=e?e[o][c]:SR,f=[];for(let p=0;p<h.length;p++){let x=h[p],m=r.get(l[p]);x===null?d!=bR&&(u[m]=x,d==wR&&f.push(m)):u[m]=x}MR(u,f,s),i.push(u)}}return i}var ER=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function TR(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function CR(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function RR(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Jn(1,gi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var k_=["January","February","March","April","May","June","July","August","September","October","November","December"],O_=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function U_(n){return n.slice(0,3)}var PR=O_.map(U_),IR=k_.map(U_),LR={MMMM:k_,MMM:IR,WWWW:O_,WWW:PR};function cl(n){return(n<10?"0":"")+n}function NR(n){return(n<10?"00":n<100?"0":"")+n}var DR={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>cl(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>cl(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>cl(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>cl(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>cl(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>NR(n.getMilliseconds())};function mp(n,e){e=e||LR;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?DR[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var kR=new Intl.DateTimeFormat().resolvedOptions().timeZone;function OR(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==kR?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var F_=n=>n%1==0,th=[1,2,2.5,5],UR=ml(10,-32,0,th),B_=ml(10,0,32,th),FR=B_.filter(F_),Ur=UR.concat(B_),gp=`
`,z_="{YYYY}",s_=gp+z_,V_="{M}/{D}",dl=gp+V_,ju=dl+"/{YY}",G_="{aa}",BR="{h}:{mm}",Ho=BR+G_,r_=gp+Ho,o_=":{ss}",kt=null;function H_(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?ml(10,0,3,th).filter(F_):ml(10,-3,0,th)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,z_,kt,kt,kt,kt,kt,kt,1],[s*28,"{MMM}",s_,kt,kt,kt,kt,kt,1],[s,V_,s_,kt,kt,kt,kt,kt,1],[i,"{h}"+G_,ju,kt,dl,kt,kt,kt,1],[t,Ho,ju,kt,dl,kt,kt,kt,1],[e,o_,ju+" "+Ho,kt,dl+" "+Ho,kt,r_,kt,1],[n,o_+".{fff}",ju+" "+Ho,kt,dl+" "+Ho,kt,r_,kt,1]];function h(u){return(d,f,p,x,m,g)=>{let _=[],w=m>=o,S=m>=r&&m<o,A=u(p),M=Wt(A*n,3),y=Zf(A.getFullYear(),w?0:A.getMonth(),S||w?1:A.getDate()),b=Wt(y*n,3);if(S||w){let T=S?m/r:0,P=w?m/o:0,C=M==b?M:Wt(Zf(y.getFullYear()+P,y.getMonth()+T,1)*n,3),D=new Date(An(C/n)),U=D.getFullYear(),N=D.getMonth();for(let z=0;C<=x;z++){let W=Zf(U+P*z,N+T*z,1),H=W-u(Wt(W*n,3));C=Wt((+W+H)*n,3),C<=x&&_.push(C)}}else{let T=m>=s?s:m,P=gi(p)-gi(M),C=b+P+sh(M-b,T);_.push(C);let D=u(C),U=D.getHours()+D.getMinutes()/t+D.getSeconds()/i,N=m/i,z=d.axes[f]._space,W=g/z;for(;C=Wt(C+m,n==1?0:3),!(C>x);)if(N>1){let H=gi(Wt(U+N,6))%24,J=u(C).getHours()-H;J>1&&(J=-1),C-=J*i,U=(U+N)%24;let te=_[_.length-1];Wt((C-te)/m,3)*W>=.7&&_.push(C)}else _.push(C)}return _}}return[l,c,h]}var[zR,VR,GR]=H_(1),[HR,WR,$R]=H_(.001);ml(2,-53,53,[1]);function a_(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function l_(n,e){return(t,i,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],l,c,h,u,d,f;return i.map(p=>{let x=n(p),m=x.getFullYear(),g=x.getMonth(),_=x.getDate(),w=x.getHours(),S=x.getMinutes(),A=x.getSeconds(),M=m!=l&&a[2]||g!=c&&a[3]||_!=h&&a[4]||w!=u&&a[5]||S!=d&&a[6]||A!=f&&a[7]||a[1];return l=m,c=g,h=_,u=w,d=S,f=A,M(x)})}}function XR(n,e){let t=mp(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function Zf(n,e,t){return new Date(n,e,t)}function c_(n,e){return e(n)}var qR="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function u_(n,e){return(t,i,s,r)=>r==null?cp:e(n(i))}function YR(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function ZR(n,e){return n.series[e].fill(n,e)}var jR={show:!0,live:!0,isolate:!1,mount:mR,markers:{show:!0,width:2,stroke:YR,fill:ZR,dash:"solid"},idx:null,idxs:null,values:[]};function KR(n,e){let t=n.cursor.points,i=Ai(),s=t.size(n,e);Jt(i,ul,s),Jt(i,hl,s);let r=s/-2;Jt(i,"marginLeft",r),Jt(i,"marginTop",r);let o=t.width(n,e,s);return o&&Jt(i,"borderWidth",o),i}function JR(n,e){let t=n.series[e].points;return t._fill||t._stroke}function QR(n,e){let t=n.series[e].points;return t._stroke||t._fill}function e2(n,e){return n.series[e].points.size}var jf=[0,0];function t2(n,e,t){return jf[0]=e,jf[1]=t,jf}function Ku(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function Kf(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var n2={show:!0,x:!0,y:!0,lock:!1,move:t2,points:{one:!1,show:KR,size:e2,width:0,stroke:QR,fill:JR},bind:{mousedown:Ku,mouseup:Ku,click:Ku,dblclick:Ku,mousemove:Kf,mouseleave:Kf,mouseenter:Kf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},W_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},xp=yn({},W_,{filter:P_}),$_=yn({},xp,{size:10}),X_=yn({},W_,{show:!1}),_p='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',q_="bold "+_p,Y_=1.5,h_={show:!0,scale:"x",stroke:lp,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:q_,side:2,grid:xp,ticks:$_,border:X_,font:_p,lineGap:Y_,rotate:0},i2="Value",s2="Time",d_={show:!0,scale:"x",auto:!1,sorted:1,min:Ht,max:-Ht,idxs:[]};function r2(n,e,t,i,s){return e.map(r=>r==null?"":fp(r))}function o2(n,e,t,i,s,r,o){let a=[],l=pr.get(s)||0;t=o?t:Wt(sh(t,s),l);for(let c=t;c<=i;c=Wt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function ip(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Ls:T_,h=gi(c(t));s=$o(l,h),l==10&&(s=Ur[Vi(s,Ur)]);let u=t,d=s*l;l==10&&(d=Ur[Vi(d,Ur)]);do a.push(u),u=u+s,l==10&&!pr.has(u)&&(u=Wt(u,pr.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=Ur[Vi(d,Ur)]));while(u<=i);return a}function a2(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?ip(n,e,Jn(l,t),i,s):[l],h=i>=0&&t<=0?[0]:[];return(t<-l?ip(n,e,Jn(l,-i),-t,s):[l]).reverse().map(d=>-d).concat(h,c)}var Z_=/./,l2=/[12357]/,c2=/[125]/,f_=/1/,sp=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function u2(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?Z_:l(7,o)-h>=c?l2:l(5,o)-h>=c?c2:f_;if(u==f_){let d=En(l(1,o)-h);if(d<c)return sp(e.slice().reverse(),a.distr,u,Ei(c/d)).reverse()}return sp(e,a.distr,u,1)}function h2(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=En(l(1,o)-l(2,o));return c<a?sp(e.slice().reverse(),3,Z_,Ei(a/c)).reverse():e}function d2(n,e,t,i){return i==null?cp:e==null?"":fp(e)}var p_={show:!0,scale:"y",stroke:lp,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:q_,side:3,grid:xp,ticks:$_,border:X_,font:_p,lineGap:Y_,rotate:0};function f2(n,e){let t=3+(n||1)*2;return Wt(t*e,3)}function p2(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=En(o-r),l=n.series[e],c=a/(l.points.space*It);return i[1]-i[0]<=c}var m_={scale:null,auto:!0,sorted:0,min:Ht,max:-Ht},j_=(n,e,t,i,s)=>s,g_={show:!0,auto:!0,sorted:0,gaps:j_,alpha:1,facets:[yn({},m_,{scale:"x"}),yn({},m_,{scale:"y"})]},x_={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:j_,alpha:1,points:{show:p2,filter:null},values:null,min:Ht,max:-Ht,idxs:[],path:null,clip:null};function m2(n,e,t,i,s){return t/10}var K_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},g2=yn({},K_,{time:!1,ori:1}),__={};function J_(n,e){let t=__[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(i,s,r,o,a,l,c)}},n!=null&&(__[n]=t)),t}var Yo=1,rp=2;function Vr(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],h=i==2?o[s.facets[0].scale]:o[n.series[0].scale],u=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,p=a.width,x=a.height,m=n.valToPosH,g=n.valToPosV;return h.ori==0?t(s,l,c,h,u,m,g,d,f,p,x,ah,jo,ch,ey,ny):t(s,l,c,h,u,g,m,f,d,x,p,lh,Ko,bp,ty,iy)}function yp(n,e){let t=0,i=0,s=Ct(n.bands,pp);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function x2(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ns(n,e,t,i,s,r){return Vr(n,e,(o,a,l,c,h,u,d,f,p,x,m)=>{let g=o.pxRound,_=c.dir*(c.ori==0?1:-1),w=c.ori==0?jo:Ko,S,A;_==1?(S=t,A=i):(S=i,A=t);let M=g(u(a[S],c,x,f)),y=g(d(l[S],h,m,p)),b=g(u(a[A],c,x,f)),T=g(d(r==1?h.max:h.min,h,m,p)),P=new Path2D(s);return w(P,b,T),w(P,M,T),w(P,M,y),P})}function oh(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?ch:bp,l=t;for(let u=0;u<n.length;u++){let d=n[u];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let c=t+s-l,h=10;c>0&&a(o,l,i-h/2,c,i+r+h)}return o}function _2(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function vp(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let u=c,d=c;if(s==1)for(;++c<=i&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=r(n[u]),p=d==u?f:r(n[d]),x=u-s;f=o<=0&&x>=0&&x<l?r(n[x]):f;let g=d+s;p=o>=0&&g>=0&&g<l?r(n[g]):p,p>=f&&a.push([f,p])}return a}function y_(n){return n==0?R_:n==1?An:e=>Or(e,n)}function Q_(n){let e=n==0?ah:lh,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?i(s,r,o,a,l):(c=Gi(c,a/2,l/2),h=Gi(h,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,h),t(s,r,o+l,r,o,h),t(s,r,o,r+a,o,c),s.closePath())}}var ah=(n,e,t)=>{n.moveTo(e,t)},lh=(n,e,t)=>{n.moveTo(t,e)},jo=(n,e,t)=>{n.lineTo(e,t)},Ko=(n,e,t)=>{n.lineTo(t,e)},ch=Q_(0),bp=Q_(1),ey=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},ty=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},ny=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},iy=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function sy(n){return(e,t,i,s,r)=>Vr(e,t,(o,a,l,c,h,u,d,f,p,x,m)=>{let{pxRound:g,points:_}=o,w,S;c.ori==0?(w=ah,S=ey):(w=lh,S=ty);let A=Wt(_.width*It,3),M=(_.size-_.width)/2*It,y=Wt(M*2,3),b=new Path2D,T=new Path2D,{left:P,top:C,width:D,height:U}=e.bbox;ch(T,P-y,C-y,D+y*2,U+y*2);let N=z=>{if(l[z]!=null){let W=g(u(a[z],c,x,f)),H=g(d(l[z],h,m,p));w(b,W+M,H),S(b,W,H,M,0,Ju*2)}};if(r)r.forEach(N);else for(let z=i;z<=s;z++)N(z);return{stroke:A>0?b:null,fill:b,clip:T,flags:Yo|rp}})}function ry(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var y2=ry(jo),v2=ry(Ko);function oy(n){let e=Ct(n?.alignGaps,0);return(t,i,s,r)=>Vr(t,i,(o,a,l,c,h,u,d,f,p,x,m)=>{[s,r]=nh(l,s,r);let g=o.pxRound,_=U=>g(u(U,c,x,f)),w=U=>g(d(U,h,m,p)),S,A;c.ori==0?(S=jo,A=y2):(S=Ko,A=v2);let M=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Yo},b=y.stroke,T=!1;if(r-s>=x*4){let U=fe=>t.posToVal(fe,c.key,!0),N=null,z=null,W,H,se,Y=_(a[M==1?s:r]),J=_(a[s]),te=_(a[r]),pe=U(M==1?J+1:te-1);for(let fe=M==1?s:r;fe>=s&&fe<=r;fe+=M){let ee=a[fe],xe=(M==1?ee<pe:ee>pe)?Y:_(ee),be=l[fe];xe==Y?be!=null?(H=be,N==null?(S(b,xe,w(H)),W=N=z=H):H<N?N=H:H>z&&(z=H)):be===null&&(T=!0):(N!=null&&A(b,Y,w(N),w(z),w(W),w(H)),be!=null?(H=be,S(b,xe,w(H)),N=z=W=H):(N=z=null,be===null&&(T=!0)),Y=xe,pe=U(Y+M))}N!=null&&N!=z&&se!=Y&&A(b,Y,w(N),w(z),w(W),w(H))}else for(let U=M==1?s:r;U>=s&&U<=r;U+=M){let N=l[U];N===null?T=!0:N!=null&&S(b,_(a[U]),w(N))}let[C,D]=yp(t,i);if(o.fill!=null||C!=0){let U=y.fill=new Path2D(b),N=o.fillTo(t,i,o.min,o.max,C),z=w(N),W=_(a[s]),H=_(a[r]);M==-1&&([H,W]=[W,H]),S(U,H,z),S(U,W,z)}if(!o.spanGaps){let U=[];T&&U.push(...vp(a,l,s,r,M,_,e)),y.gaps=U=o.gaps(t,i,s,r,U),y.clip=oh(U,c.ori,f,p,x,m)}return D!=0&&(y.band=D==2?[Ns(t,i,s,r,b,-1),Ns(t,i,s,r,b,1)]:Ns(t,i,s,r,b,D)),y})}function b2(n){let e=Ct(n.align,1),t=Ct(n.ascDesc,!1),i=Ct(n.alignGaps,0),s=Ct(n.extend,!1);return(r,o,a,l)=>Vr(r,o,(c,h,u,d,f,p,x,m,g,_,w)=>{[a,l]=nh(u,a,l);let S=c.pxRound,{left:A,width:M}=r.bbox,y=J=>S(p(J,d,_,m)),b=J=>S(x(J,f,w,g)),T=d.ori==0?jo:Ko,P={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Yo},C=P.stroke,D=d.dir*(d.ori==0?1:-1),U=b(u[D==1?a:l]),N=y(h[D==1?a:l]),z=N,W=N;s&&e==-1&&(W=A,T(C,W,U)),T(C,N,U);for(let J=D==1?a:l;J>=a&&J<=l;J+=D){let te=u[J];if(te==null)continue;let pe=y(h[J]),fe=b(te);e==1?T(C,pe,U):T(C,z,fe),T(C,pe,fe),U=fe,z=pe}let H=z;s&&e==1&&(H=A+M,T(C,H,U));let[se,Y]=yp(r,o);if(c.fill!=null||se!=0){let J=P.fill=new Path2D(C),te=c.fillTo(r,o,c.min,c.max,se),pe=b(te);T(J,H,pe),T(J,W,pe)}if(!c.spanGaps){let J=[];J.push(...vp(h,u,a,l,D,y,i));let te=c.width*It/2,pe=t||e==1?te:-te,fe=t||e==-1?-te:te;J.forEach(ee=>{ee[0]+=pe,ee[1]+=fe}),P.gaps=J=c.gaps(r,o,a,l,J),P.clip=oh(J,d.ori,m,g,_,w)}return Y!=0&&(P.band=Y==2?[Ns(r,o,a,l,C,-1),Ns(r,o,a,l,C,1)]:Ns(r,o,a,l,C,Y)),P})}function v_(n,e,t,i,s,r,o=Ht){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let h=En(n[l]-n[a]);h<c&&(c=h,o=En(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function S2(n){n=n||pl;let e=Ct(n.size,[.6,Ht,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=wt(s),o=1-e[0],a=Ct(e[1],Ht),l=Ct(e[2],1),c=Ct(n.disp,pl),h=Ct(n.each,f=>{}),{fill:u,stroke:d}=c;return(f,p,x,m)=>Vr(f,p,(g,_,w,S,A,M,y,b,T,P,C)=>{let D=g.pxRound,U=t,N=i*It,z=a*It,W=l*It,H,se;S.ori==0?[H,se]=r(f,p):[se,H]=r(f,p);let Y=S.dir*(S.ori==0?1:-1),J=S.ori==0?ch:bp,te=S.ori==0?h:(de,ke,Qe,ye,Et,ze,Ye)=>{h(de,ke,Qe,Et,ye,Ye,ze)},pe=Ct(f.bands,pp).find(de=>de.series[0]==p),fe=pe!=null?pe.dir:0,ee=g.fillTo(f,p,g.min,g.max,fe),he=D(y(ee,A,C,T)),xe,be,Se,$e=P,ot=D(g.width*It),We=!1,lt=null,ct=null,et=null,$t=null;u!=null&&(ot==0||d!=null)&&(We=!0,lt=u.values(f,p,x,m),ct=new Map,new Set(lt).forEach(de=>{de!=null&&ct.set(de,new Path2D)}),ot>0&&(et=d.values(f,p,x,m),$t=new Map,new Set(et).forEach(de=>{de!=null&&$t.set(de,new Path2D)})));let{x0:Bt,size:en}=c;if(Bt!=null&&en!=null){U=1,_=Bt.values(f,p,x,m),Bt.unit==2&&(_=_.map(Qe=>f.posToVal(b+Qe*P,S.key,!0)));let de=en.values(f,p,x,m);en.unit==2?be=de[0]*P:be=M(de[0],S,P,b)-M(0,S,P,b),$e=v_(_,w,M,S,P,b,$e),Se=$e-be+N}else $e=v_(_,w,M,S,P,b,$e),Se=$e*o+N,be=$e-Se;Se<1&&(Se=0),ot>=be/2&&(ot=0),Se<5&&(D=R_);let At=Se>0,dn=$e-Se-(At?ot:0);be=D(np(dn,W,z)),xe=(U==0?be/2:U==Y?0:be)-U*Y*((U==0?N/2:0)+(At?ot/2:0));let vt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},we=We?null:new Path2D,Fe=null;if(pe!=null)Fe=f.data[pe.series[1]];else{let{y0:de,y1:ke}=c;de!=null&&ke!=null&&(w=ke.values(f,p,x,m),Fe=de.values(f,p,x,m))}let Ze=H*be,B=se*be;for(let de=Y==1?x:m;de>=x&&de<=m;de+=Y){let ke=w[de];if(ke==null)continue;if(Fe!=null){let q=Fe[de]??0;if(ke-q==0)continue;he=y(q,A,C,T)}let Qe=S.distr!=2||c!=null?_[de]:de,ye=M(Qe,S,P,b),Et=y(Ct(ke,ee),A,C,T),ze=D(ye-xe),Ye=D(Jn(Et,he)),k=D(Gi(Et,he)),R=Ye-k;if(ke!=null){let q=ke<0?B:Ze,ce=ke<0?Ze:B;We?(ot>0&&et[de]!=null&&J($t.get(et[de]),ze,k+gi(ot/2),be,Jn(0,R-ot),q,ce),lt[de]!=null&&J(ct.get(lt[de]),ze,k+gi(ot/2),be,Jn(0,R-ot),q,ce)):J(we,ze,k+gi(ot/2),be,Jn(0,R-ot),q,ce),te(f,p,de,ze-ot/2,k,be+ot,R)}}return ot>0?vt.stroke=We?$t:we:We||(vt._fill=g.width==0?g._fill:g._stroke??g._fill,vt.width=0),vt.fill=We?ct:we,vt})}function w2(n,e){let t=Ct(e?.alignGaps,0);return(i,s,r,o)=>Vr(i,s,(a,l,c,h,u,d,f,p,x,m,g)=>{[r,o]=nh(c,r,o);let _=a.pxRound,w=H=>_(d(H,h,m,p)),S=H=>_(f(H,u,g,x)),A,M,y;h.ori==0?(A=ah,y=jo,M=ny):(A=lh,y=Ko,M=iy);let b=h.dir*(h.ori==0?1:-1),T=w(l[b==1?r:o]),P=T,C=[],D=[];for(let H=b==1?r:o;H>=r&&H<=o;H+=b)if(c[H]!=null){let Y=l[H],J=w(Y);C.push(P=J),D.push(S(c[H]))}let U={stroke:n(C,D,A,y,M,_),fill:null,clip:null,band:null,gaps:null,flags:Yo},N=U.stroke,[z,W]=yp(i,s);if(a.fill!=null||z!=0){let H=U.fill=new Path2D(N),se=a.fillTo(i,s,a.min,a.max,z),Y=S(se);y(H,P,Y),y(H,T,Y)}if(!a.spanGaps){let H=[];H.push(...vp(l,c,r,o,b,w,t)),U.gaps=H=a.gaps(i,s,r,o,H),U.clip=oh(H,h.ori,p,x,m,g)}return W!=0&&(U.band=W==2?[Ns(i,s,r,o,N,-1),Ns(i,s,r,o,N,1)]:Ns(i,s,r,o,N,W)),U})}function M2(n){return w2(A2,n)}function A2(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=e[d+1]-e[d],u[d]=n[d+1]-n[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+u[d]/3,e[d]+l[d]*u[d]/3,n[d+1]-u[d]/3,e[d+1]-l[d+1]*u[d]/3,n[d+1],e[d+1])}return a}var op=new Set;function b_(){for(let n of op)n.syncRect(!0)}Zo&&(Br(rR,Wo,b_),Br(oR,Wo,b_,!0),Br(Qu,Wo,()=>{hn.pxRatio=It}));var E2=oy(),T2=sy();function S_(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>ap(r,o,e,t))}function C2(n,e){return n.map((t,i)=>i==0?{}:yn({},e,t))}function ap(n,e,t,i){return yn({},e==0?t:i,n)}function ay(n,e,t){return e==null?Xo:[e,t]}var R2=ay;function P2(n,e,t){return e==null?Xo:eh(e,t,dp,!0)}function ly(n,e,t,i){return e==null?Xo:ih(e,t,n.scales[i].log,!1)}var I2=ly;function cy(n,e,t,i){return e==null?Xo:hp(e,t,n.scales[i].log,!1)}var L2=cy;function N2(n,e,t,i,s){let r=Jn(e_(n),e_(e)),o=e-n,a=Vi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?pr.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function w_(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=An((t=+s)*It))+"px"),[n,e,t]}function D2(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Wt(e[2]*It,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function hn(n,e,t){let i={mode:Ct(n.mode,1)},s=i.mode;function r(E,I,O,F){let X=I.valToPct(E);return F+O*(I.dir==-1?1-X:X)}function o(E,I,O,F){let X=I.valToPct(E);return F+O*(I.dir==-1?X:1-X)}function a(E,I,O,F){return I.ori==0?r(E,I,O,F):o(E,I,O,F)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Ai(VC);if(n.id!=null&&(c.id=n.id),mi(c,n.class),n.title){let E=Ai(WC,c);E.textContent=n.title}let h=zi("canvas"),u=i.ctx=h.getContext("2d"),d=Ai($C,c);Br("click",d,E=>{E.target===p&&(qt!=jr||Qt!=Kr)&&Dn.click(i,E)},!0);let f=i.under=Ai(XC,d);d.appendChild(h);let p=i.over=Ai(qC,d);n=qo(n);let x=+Ct(n.pxAlign,1),m=y_(x);(n.plugins||[]).forEach(E=>{E.opts&&(n=E.opts(i,n)||n)});let g=n.ms||.001,_=i.series=s==1?S_(n.series||[],d_,x_,!1):C2(n.series||[null],g_),w=i.axes=S_(n.axes||[],h_,p_,!0),S=i.scales={},A=i.bands=n.bands||[];A.forEach(E=>{E.fill=wt(E.fill||null),E.dir=Ct(E.dir,-1)});let M=s==2?_[1].facets[0].scale:_[0].scale,y={axes:hs,series:gt},b=(n.drawOrder||["axes","series"]).map(E=>y[E]);function T(E){let I=E.distr==3?O=>Ls(O>0?O:E.clamp(i,O,E.min,E.max,E.key)):E.distr==4?O=>Yf(O,E.asinh):E.distr==100?O=>E.fwd(O):O=>O;return O=>{let F=I(O),{_min:X,_max:K}=E,le=K-X;return(F-X)/le}}function P(E){let I=S[E];if(I==null){let O=(n.scales||pl)[E]||pl;if(O.from!=null){P(O.from);let F=yn({},S[O.from],O,{key:E});F.valToPct=T(F),S[E]=F}else{I=S[E]=yn({},E==M?K_:g2,O),I.key=E;let F=I.time,X=I.range,K=fr(X);if((E!=M||s==2&&!F)&&(K&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?Kx:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?Kx:{mode:1,hard:X[1],soft:X[1]}},K=!1),!K&&rh(X))){let le=X;X=(me,Ae,De)=>Ae==null?Xo:eh(Ae,De,le)}I.range=wt(X||(F?R2:E==M?I.distr==3?I2:I.distr==4?L2:ay:I.distr==3?ly:I.distr==4?cy:P2)),I.auto=wt(K?!1:I.auto),I.clamp=wt(I.clamp||m2),I._min=I._max=null,I.valToPct=T(I)}}}P("x"),P("y"),s==1&&_.forEach(E=>{P(E.scale)}),w.forEach(E=>{P(E.scale)});for(let E in n.scales)P(E);let C=S[M],D=C.distr,U,N;C.ori==0?(mi(c,GC),U=r,N=o):(mi(c,HC),U=o,N=r);let z={};for(let E in S){let I=S[E];(I.min!=null||I.max!=null)&&(z[E]={min:I.min,max:I.max},I.min=I.max=null)}let W=n.tzDate||(E=>new Date(An(E/g))),H=n.fmtDate||mp,se=g==1?GR(W):$R(W),Y=l_(W,a_(g==1?VR:WR,H)),J=u_(W,c_(qR,H)),te=[],pe=i.legend=yn({},jR,n.legend),fe=i.cursor=yn({},n2,{drag:{y:s==2}},n.cursor),ee=pe.show,he=fe.show,xe=pe.markers;pe.idxs=te,xe.width=wt(xe.width),xe.dash=wt(xe.dash),xe.stroke=wt(xe.stroke),xe.fill=wt(xe.fill);let be,Se,$e,ot=[],We=[],lt,ct=!1,et={};if(pe.live){let E=_[1]?_[1].values:null;ct=E!=null,lt=ct?E(i,1,0):{_:0};for(let I in lt)et[I]=cp}if(ee)if(be=zi("table",QC,c),$e=zi("tbody",null,be),pe.mount(i,be),ct){Se=zi("thead",null,be,$e);let E=zi("tr",null,Se);zi("th",null,E);for(var $t in lt)zi("th",Fx,E).textContent=$t}else mi(be,tR),pe.live&&mi(be,eR);let Bt={show:!0},en={show:!1};function At(E,I){if(I==0&&(ct||!pe.live||s==2))return Xo;let O=[],F=zi("tr",nR,$e,$e.childNodes[I]);mi(F,E.class),E.show||mi(F,Fr);let X=zi("th",null,F);if(xe.show){let me=Ai(iR,X);if(I>0){let Ae=xe.width(i,I);Ae&&(me.style.border=Ae+"px "+xe.dash(i,I)+" "+xe.stroke(i,I)),me.style.background=xe.fill(i,I)}}let K=Ai(Fx,X);E.label instanceof HTMLElement?K.appendChild(E.label):K.textContent=E.label,I>0&&(xe.show||(K.style.color=E.width>0?xe.stroke(i,I):xe.fill(i,I)),vt("click",X,me=>{if(fe._lock)return;nt(me);let Ae=_.indexOf(E);if((me.ctrlKey||me.metaKey)!=pe.isolate){let De=_.some((Oe,Be)=>Be>0&&Be!=Ae&&Oe.show);_.forEach((Oe,Be)=>{Be>0&&Xi(Be,De?Be==Ae?Bt:en:Bt,!0,gn.setSeries)})}else Xi(Ae,{show:!E.show},!0,gn.setSeries)},!1),it&&vt(Gx,X,me=>{fe._lock||(nt(me),Xi(_.indexOf(E),Qr,!0,gn.setSeries))},!1));for(var le in lt){let me=zi("td",sR,F);me.textContent="--",O.push(me)}return[F,O]}let dn=new Map;function vt(E,I,O,F=!0){let X=dn.get(I)||{},K=fe.bind[E](i,I,O,F);K&&(Br(E,I,X[E]=K),dn.set(I,X))}function we(E,I,O){let F=dn.get(I)||{};for(let X in F)(E==null||X==E)&&(tp(X,I,F[X]),delete F[X]);E==null&&dn.delete(I)}let Fe=0,Ze=0,B=0,de=0,ke=0,Qe=0,ye=ke,Et=Qe,ze=B,Ye=de,k=0,R=0,q=0,ce=0;i.bbox={};let ae=!1,ve=!1,Me=!1,ne=!1,re=!1,ge=!1;function V(E,I,O){(O||E!=i.width||I!=i.height)&&oe(E,I),ft(!1),Me=!0,ve=!0,Un()}function oe(E,I){i.width=Fe=B=E,i.height=Ze=de=I,ke=Qe=0,Ee(),Xe();let O=i.bbox;k=O.left=Or(ke*It,.5),R=O.top=Or(Qe*It,.5),q=O.width=Or(B*It,.5),ce=O.height=Or(de*It,.5)}let ie=3;function Te(){let E=!1,I=0;for(;!E;){I++;let O=qr(I),F=$i(I);E=I==ie||O&&F,E||(oe(i.width,i.height),ve=!0)}}function _e({width:E,height:I}){V(E,I)}i.setSize=_e;function Ee(){let E=!1,I=!1,O=!1,F=!1;w.forEach((X,K)=>{if(X.show&&X._show){let{side:le,_size:me}=X,Ae=le%2,De=X.label!=null?X.labelSize:0,Oe=me+De;Oe>0&&(Ae?(B-=Oe,le==3?(ke+=Oe,F=!0):O=!0):(de-=Oe,le==0?(Qe+=Oe,E=!0):I=!0))}}),Hi[0]=E,Hi[1]=O,Hi[2]=I,Hi[3]=F,B-=Ci[1]+Ci[3],ke+=Ci[3],de-=Ci[2]+Ci[0],Qe+=Ci[0]}function Xe(){let E=ke+B,I=Qe+de,O=ke,F=Qe;function X(K,le){switch(K){case 1:return E+=le,E-le;case 2:return I+=le,I-le;case 3:return O-=le,O+le;case 0:return F-=le,F+le}}w.forEach((K,le)=>{if(K.show&&K._show){let me=K.side;K._pos=X(me,K._size),K.label!=null&&(K._lpos=X(me,K.labelSize))}})}if(fe.dataIdx==null){let E=fe.hover,I=E.skip=new Set(E.skip??[]);I.add(void 0);let O=E.prox=wt(E.prox),F=E.bias??=0;fe.dataIdx=(X,K,le,me)=>{if(K==0)return le;let Ae=le,De=O(X,K,le,me)??Ht,Oe=De>=0&&De<Ht,Be=C.ori==0?B:de,ut=fe.left,Rt=e[0],Tt=e[K];if(I.has(Tt[le])){Ae=null;let yt=null,tt=null,qe;if(F==0||F==-1)for(qe=le;yt==null&&qe-- >0;)I.has(Tt[qe])||(yt=qe);if(F==0||F==1)for(qe=le;tt==null&&qe++<Tt.length;)I.has(Tt[qe])||(tt=qe);if(yt!=null||tt!=null)if(Oe){let Zt=yt==null?-1/0:U(Rt[yt],C,Be,0),rn=tt==null?1/0:U(Rt[tt],C,Be,0),Pn=ut-Zt,zt=rn-ut;Pn<=zt?Pn<=De&&(Ae=yt):zt<=De&&(Ae=tt)}else Ae=tt==null?yt:yt==null?tt:le-yt<=tt-le?yt:tt}else Oe&&En(ut-U(Rt[le],C,Be,0))>De&&(Ae=null);return Ae}}let nt=E=>{fe.event=E};fe.idxs=te,fe._lock=!1;let ue=fe.points;ue.show=wt(ue.show),ue.size=wt(ue.size),ue.stroke=wt(ue.stroke),ue.width=wt(ue.width),ue.fill=wt(ue.fill);let Ve=i.focus=yn({},n.focus||{alpha:.3},fe.focus),it=Ve.prox>=0,Pe=it&&ue.one,ht=[],Xt=[],Gn=[];function na(E,I){let O=ue.show(i,I);if(O instanceof HTMLElement)return mi(O,JC),mi(O,E.class),os(O,-10,-10,B,de),p.insertBefore(O,ht[I]),O}function Wr(E,I){if(s==1||I>0){let O=s==1&&S[E.scale].time,F=E.value;E.value=O?i_(F)?u_(W,c_(F,H)):F||J:F||d2,E.label=E.label||(O?s2:i2)}if(Pe||I>0){E.width=E.width==null?1:E.width,E.paths=E.paths||E2||gR,E.fillTo=wt(E.fillTo||x2),E.pxAlign=+Ct(E.pxAlign,x),E.pxRound=y_(E.pxAlign),E.stroke=wt(E.stroke||null),E.fill=wt(E.fill||null),E._stroke=E._fill=E._paths=E._focus=null;let O=f2(Jn(1,E.width),1),F=E.points=yn({},{size:O,width:Jn(1,O*.2),stroke:E.stroke,space:O*2,paths:T2,_stroke:null,_fill:null},E.points);F.show=wt(F.show),F.filter=wt(F.filter),F.fill=wt(F.fill),F.stroke=wt(F.stroke),F.paths=wt(F.paths),F.pxAlign=E.pxAlign}if(ee){let O=At(E,I);ot.splice(I,0,O[0]),We.splice(I,0,O[1]),pe.values.push(null)}if(he){te.splice(I,0,null);let O=null;Pe?I==0&&(O=na(E,I)):I>0&&(O=na(E,I)),ht.splice(I,0,O),Xt.splice(I,0,0),Gn.splice(I,0,0)}Rn("addSeries",I)}function Uh(E,I){I=I??_.length,E=s==1?ap(E,I,d_,x_):ap(E,I,{},g_),_.splice(I,0,E),Wr(_[I],I)}i.addSeries=Uh;function wl(E){if(_.splice(E,1),ee){pe.values.splice(E,1),We.splice(E,1);let I=ot.splice(E,1)[0];we(null,I.firstChild),I.remove()}he&&(te.splice(E,1),ht.splice(E,1)[0].remove(),Xt.splice(E,1),Gn.splice(E,1)),Rn("delSeries",E)}i.delSeries=wl;let Hi=[!1,!1,!1,!1];function ls(E,I){if(E._show=E.show,E.show){let O=E.side%2,F=S[E.scale];F==null&&(E.scale=O?_[1].scale:M,F=S[E.scale]);let X=F.time;E.size=wt(E.size),E.space=wt(E.space),E.rotate=wt(E.rotate),fr(E.incrs)&&E.incrs.forEach(le=>{!pr.has(le)&&pr.set(le,L_(le))}),E.incrs=wt(E.incrs||(F.distr==2?FR:X?g==1?zR:HR:Ur)),E.splits=wt(E.splits||(X&&F.distr==1?se:F.distr==3?ip:F.distr==4?a2:o2)),E.stroke=wt(E.stroke),E.grid.stroke=wt(E.grid.stroke),E.ticks.stroke=wt(E.ticks.stroke),E.border.stroke=wt(E.border.stroke);let K=E.values;E.values=fr(K)&&!fr(K[0])?wt(K):X?fr(K)?l_(W,a_(K,H)):i_(K)?XR(W,K):K||Y:K||r2,E.filter=wt(E.filter||(F.distr>=3&&F.log==10?u2:F.distr==3&&F.log==2?h2:P_)),E.font=w_(E.font),E.labelFont=w_(E.labelFont),E._size=E.size(i,null,I,0),E._space=E._rotate=E._incrs=E._found=E._splits=E._values=null,E._size>0&&(Hi[I]=!0,E._el=Ai(YC,d))}}function cs(E,I,O,F){let[X,K,le,me]=O,Ae=I%2,De=0;return Ae==0&&(me||K)&&(De=I==0&&!X||I==2&&!le?An(h_.size/3):0),Ae==1&&(X||le)&&(De=I==1&&!K||I==3&&!me?An(p_.size/2):0),De}let ia=i.padding=(n.padding||[cs,cs,cs,cs]).map(E=>wt(Ct(E,cs))),Ci=i._padding=ia.map((E,I)=>E(i,I,Hi,0)),nn,ln=null,cn=null,Wi=s==1?_[0].idxs:null,ii=null,Os=!1;function sa(E,I){if(e=E??[],i.data=i._data=e,s==2){nn=0;for(let O=1;O<_.length;O++)nn+=e[O][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),ii=e[0],nn=ii.length;let O=e;if(D==2){O=e.slice();let F=O[0]=Array(nn);for(let X=0;X<nn;X++)F[X]=X}i._data=e=O}if(ft(!0),Rn("setData"),D==2&&(Me=!0),I!==!1){let O=C;O.auto(i,Os)?ra():Bs(M,O.min,O.max),ne=ne||fe.left>=0,ge=!0,Un()}}i.setData=sa;function ra(){Os=!0;let E,I;s==1&&(nn>0?(ln=Wi[0]=0,cn=Wi[1]=nn-1,E=e[0][ln],I=e[0][cn],D==2?(E=ln,I=cn):E==I&&(D==3?[E,I]=ih(E,E,C.log,!1):D==4?[E,I]=hp(E,E,C.log,!1):C.time?I=E+An(86400/g):[E,I]=eh(E,I,dp,!0))):(ln=Wi[0]=E=null,cn=Wi[1]=I=null)),Bs(M,E,I)}let $r,Us,Xr,L,$,Q,Z,j,Ce,Ie;function Re(E,I,O,F,X,K){E??=zx,O??=pp,F??="butt",X??=zx,K??="round",E!=$r&&(u.strokeStyle=$r=E),X!=Us&&(u.fillStyle=Us=X),I!=Xr&&(u.lineWidth=Xr=I),K!=$&&(u.lineJoin=$=K),F!=Q&&(u.lineCap=Q=F),O!=L&&u.setLineDash(L=O)}function Le(E,I,O,F){I!=Us&&(u.fillStyle=Us=I),E!=Z&&(u.font=Z=E),O!=j&&(u.textAlign=j=O),F!=Ce&&(u.textBaseline=Ce=F)}function He(E,I,O,F,X=0){if(F.length>0&&E.auto(i,Os)&&(I==null||I.min==null)){let K=Ct(ln,0),le=Ct(cn,F.length-1),me=O.min==null?uR(F,K,le,X,E.distr==3):[O.min,O.max];E.min=Gi(E.min,O.min=me[0]),E.max=Jn(E.max,O.max=me[1])}}let at={min:null,max:null};function mt(){for(let F in S){let X=S[F];z[F]==null&&(X.min==null||z[M]!=null&&X.auto(i,Os))&&(z[F]=at)}for(let F in S){let X=S[F];z[F]==null&&X.from!=null&&z[X.from]!=null&&(z[F]=at)}z[M]!=null&&ft(!0);let E={};for(let F in z){let X=z[F];if(X!=null){let K=E[F]=qo(S[F],yR);if(X.min!=null)yn(K,X);else if(F!=M||s==2)if(nn==0&&K.from==null){let le=K.range(i,null,null,F);K.min=le[0],K.max=le[1]}else K.min=Ht,K.max=-Ht}}if(nn>0){_.forEach((F,X)=>{if(s==1){let K=F.scale,le=z[K];if(le==null)return;let me=E[K];if(X==0){let Ae=me.range(i,me.min,me.max,K);me.min=Ae[0],me.max=Ae[1],ln=Vi(me.min,e[0]),cn=Vi(me.max,e[0]),cn-ln>1&&(e[0][ln]<me.min&&ln++,e[0][cn]>me.max&&cn--),F.min=ii[ln],F.max=ii[cn]}else F.show&&F.auto&&He(me,le,F,e[X],F.sorted);F.idxs[0]=ln,F.idxs[1]=cn}else if(X>0&&F.show&&F.auto){let[K,le]=F.facets,me=K.scale,Ae=le.scale,[De,Oe]=e[X],Be=E[me],ut=E[Ae];Be!=null&&He(Be,z[me],K,De,K.sorted),ut!=null&&He(ut,z[Ae],le,Oe,le.sorted),F.min=le.min,F.max=le.max}});for(let F in E){let X=E[F],K=z[F];if(X.from==null&&(K==null||K.min==null)){let le=X.range(i,X.min==Ht?null:X.min,X.max==-Ht?null:X.max,F);X.min=le[0],X.max=le[1]}}}for(let F in E){let X=E[F];if(X.from!=null){let K=E[X.from];if(K.min==null)X.min=X.max=null;else{let le=X.range(i,K.min,K.max,F);X.min=le[0],X.max=le[1]}}}let I={},O=!1;for(let F in E){let X=E[F],K=S[F];if(K.min!=X.min||K.max!=X.max){K.min=X.min,K.max=X.max;let le=K.distr;K._min=le==3?Ls(K.min):le==4?Yf(K.min,K.asinh):le==100?K.fwd(K.min):K.min,K._max=le==3?Ls(K.max):le==4?Yf(K.max,K.asinh):le==100?K.fwd(K.max):K.max,I[F]=O=!0}}if(O){_.forEach((F,X)=>{s==2?X>0&&I.y&&(F._paths=null):I[F.scale]&&(F._paths=null)});for(let F in I)Me=!0,Rn("setScale",F);he&&fe.left>=0&&(ne=ge=!0)}for(let F in z)z[F]=null}function Ge(E){let I=np(ln-1,0,nn-1),O=np(cn+1,0,nn-1);for(;E[I]==null&&I>0;)I--;for(;E[O]==null&&O<nn-1;)O++;return[I,O]}function gt(){if(nn>0){let E=_.some(I=>I._focus)&&Ie!=Ve.alpha;E&&(u.globalAlpha=Ie=Ve.alpha),_.forEach((I,O)=>{if(O>0&&I.show&&(tn(O,!1),tn(O,!0),I._paths==null)){let F=Ie;Ie!=I.alpha&&(u.globalAlpha=Ie=I.alpha);let X=s==2?[0,e[O][0].length-1]:Ge(e[O]);I._paths=I.paths(i,O,X[0],X[1]),Ie!=F&&(u.globalAlpha=Ie=F)}}),_.forEach((I,O)=>{if(O>0&&I.show){let F=Ie;Ie!=I.alpha&&(u.globalAlpha=Ie=I.alpha),I._paths!=null&&Ot(O,!1);{let X=I._paths!=null?I._paths.gaps:null,K=I.points.show(i,O,ln,cn,X),le=I.points.filter(i,O,K,X);(K||le)&&(I.points._paths=I.points.paths(i,O,ln,cn,le),Ot(O,!0))}Ie!=F&&(u.globalAlpha=Ie=F),Rn("drawSeries",O)}}),E&&(u.globalAlpha=Ie=1)}}function tn(E,I){let O=I?_[E].points:_[E];O._stroke=O.stroke(i,E),O._fill=O.fill(i,E)}function Ot(E,I){let O=I?_[E].points:_[E],{stroke:F,fill:X,clip:K,flags:le,_stroke:me=O._stroke,_fill:Ae=O._fill,_width:De=O.width}=O._paths;De=Wt(De*It,3);let Oe=null,Be=De%2/2;I&&Ae==null&&(Ae=De>0?"#fff":me);let ut=O.pxAlign==1&&Be>0;if(ut&&u.translate(Be,Be),!I){let Rt=k-De/2,Tt=R-De/2,yt=q+De,tt=ce+De;Oe=new Path2D,Oe.rect(Rt,Tt,yt,tt)}I?Ue(me,De,O.dash,O.cap,Ae,F,X,le,K):Ut(E,me,De,O.dash,O.cap,Ae,F,X,le,Oe,K),ut&&u.translate(-Be,-Be)}function Ut(E,I,O,F,X,K,le,me,Ae,De,Oe){let Be=!1;Ae!=0&&A.forEach((ut,Rt)=>{if(ut.series[0]==E){let Tt=_[ut.series[1]],yt=e[ut.series[1]],tt=(Tt._paths||pl).band;fr(tt)&&(tt=ut.dir==1?tt[0]:tt[1]);let qe,Zt=null;Tt.show&&tt&&dR(yt,ln,cn)?(Zt=ut.fill(i,Rt)||K,qe=Tt._paths.clip):tt=null,Ue(I,O,F,X,Zt,le,me,Ae,De,Oe,qe,tt),Be=!0}}),Be||Ue(I,O,F,X,K,le,me,Ae,De,Oe)}let vn=Yo|rp;function Ue(E,I,O,F,X,K,le,me,Ae,De,Oe,Be){Re(E,I,O,F,X),(Ae||De||Be)&&(u.save(),Ae&&u.clip(Ae),De&&u.clip(De)),Be?(me&vn)==vn?(u.clip(Be),Oe&&u.clip(Oe),bt(X,le),fn(E,K,I)):me&rp?(bt(X,le),u.clip(Be),fn(E,K,I)):me&Yo&&(u.save(),u.clip(Be),Oe&&u.clip(Oe),bt(X,le),u.restore(),fn(E,K,I)):(bt(X,le),fn(E,K,I)),(Ae||De||Be)&&u.restore()}function fn(E,I,O){O>0&&(I instanceof Map?I.forEach((F,X)=>{u.strokeStyle=$r=X,u.stroke(F)}):I!=null&&E&&u.stroke(I))}function bt(E,I){I instanceof Map?I.forEach((O,F)=>{u.fillStyle=Us=F,u.fill(O)}):I!=null&&E&&u.fill(I)}function us(E,I,O,F){let X=w[E],K;if(F<=0)K=[0,0];else{let le=X._space=X.space(i,E,I,O,F),me=X._incrs=X.incrs(i,E,I,O,F,le);K=N2(I,O,me,F,le)}return X._found=K}function pn(E,I,O,F,X,K,le,me,Ae,De){let Oe=le%2/2;x==1&&u.translate(Oe,Oe),Re(me,le,Ae,De,me),u.beginPath();let Be,ut,Rt,Tt,yt=X+(F==0||F==3?-K:K);O==0?(ut=X,Tt=yt):(Be=X,Rt=yt);for(let tt=0;tt<E.length;tt++)I[tt]!=null&&(O==0?Be=Rt=E[tt]:ut=Tt=E[tt],u.moveTo(Be,ut),u.lineTo(Rt,Tt));u.stroke(),x==1&&u.translate(-Oe,-Oe)}function qr(E){let I=!0;return w.forEach((O,F)=>{if(!O.show)return;let X=S[O.scale];if(X.min==null){O._show&&(I=!1,O._show=!1,ft(!1));return}else O._show||(I=!1,O._show=!0,ft(!1));let K=O.side,le=K%2,{min:me,max:Ae}=X,[De,Oe]=us(F,me,Ae,le==0?B:de);if(Oe==0)return;let Be=X.distr==2,ut=O._splits=O.splits(i,F,me,Ae,De,Oe,Be),Rt=X.distr==2?ut.map(qe=>ii[qe]):ut,Tt=X.distr==2?ii[ut[1]]-ii[ut[0]]:De,yt=O._values=O.values(i,O.filter(i,Rt,F,Oe,Tt),F,Oe,Tt);O._rotate=K==2?O.rotate(i,yt,F,Oe):0;let tt=O._size;O._size=Ei(O.size(i,yt,F,E)),tt!=null&&O._size!=tt&&(I=!1)}),I}function $i(E){let I=!0;return ia.forEach((O,F)=>{let X=O(i,F,Hi,E);X!=Ci[F]&&(I=!1),Ci[F]=X}),I}function hs(){for(let E=0;E<w.length;E++){let I=w[E];if(!I.show||!I._show)continue;let O=I.side,F=O%2,X,K,le=I.stroke(i,E),me=O==0||O==3?-1:1,[Ae,De]=I._found;if(I.label!=null){let $n=I.labelGap*me,oi=An((I._lpos+$n)*It);Le(I.labelFont[0],le,"center",O==2?"top":Bx),u.save(),F==1?(X=K=0,u.translate(oi,An(R+ce/2)),u.rotate((O==3?-Ju:Ju)/2)):(X=An(k+q/2),K=oi);let yr=C_(I.label)?I.label(i,E,Ae,De):I.label;u.fillText(yr,X,K),u.restore()}if(De==0)continue;let Oe=S[I.scale],Be=F==0?q:ce,ut=F==0?k:R,Rt=I._splits,Tt=Oe.distr==2?Rt.map($n=>ii[$n]):Rt,yt=Oe.distr==2?ii[Rt[1]]-ii[Rt[0]]:Ae,tt=I.ticks,qe=I.border,Zt=tt.show?tt.size:0,rn=An(Zt*It),Pn=An((I.alignTo==2?I._size-Zt-I.gap:I.gap)*It),zt=I._rotate*-Ju/180,on=m(I._pos*It),si=(rn+Pn)*me,Wn=on+si;K=F==0?Wn:0,X=F==1?Wn:0;let yi=I.font[0],Ri=I.align==1?Go:I.align==2?$f:zt>0?Go:zt<0?$f:F==0?"center":O==3?$f:Go,Yi=zt||F==1?"middle":O==2?"top":Bx;Le(yi,le,Ri,Yi);let ri=I.font[1]*I.lineGap,vi=Rt.map($n=>m(a($n,Oe,Be,ut))),Pi=I._values;for(let $n=0;$n<Pi.length;$n++){let oi=Pi[$n];if(oi!=null){F==0?X=vi[$n]:K=vi[$n],oi=""+oi;let yr=oi.indexOf(`
`)==-1?[oi]:oi.split(/\n/gm);for(let Xn=0;Xn<yr.length;Xn++){let _m=yr[Xn];zt?(u.save(),u.translate(X,K+Xn*ri),u.rotate(zt),u.fillText(_m,0,0),u.restore()):u.fillText(_m,X,K+Xn*ri)}}}tt.show&&pn(vi,tt.filter(i,Tt,E,De,yt),F,O,on,rn,Wt(tt.width*It,3),tt.stroke(i,E),tt.dash,tt.cap);let Zi=I.grid;Zi.show&&pn(vi,Zi.filter(i,Tt,E,De,yt),F,F==0?2:1,F==0?R:k,F==0?ce:q,Wt(Zi.width*It,3),Zi.stroke(i,E),Zi.dash,Zi.cap),qe.show&&pn([on],[1],F==0?1:0,F==0?1:2,F==1?R:k,F==1?ce:q,Wt(qe.width*It,3),qe.stroke(i,E),qe.dash,qe.cap)}Rn("drawAxes")}function ft(E){_.forEach((I,O)=>{O>0&&(I._paths=null,E&&(s==1?(I.min=null,I.max=null):I.facets.forEach(F=>{F.min=null,F.max=null})))})}let sn=!1,Hn=!1,Ft=[];function mn(){Hn=!1;for(let E=0;E<Ft.length;E++)Rn(...Ft[E]);Ft.length=0}function Un(){sn||(ER(em),sn=!0)}function Ml(E,I=!1){sn=!0,Hn=I,E(i),em(),I&&Ft.length>0&&queueMicrotask(mn)}i.batch=Ml;function em(){if(ae&&(mt(),ae=!1),Me&&(Te(),Me=!1),ve){if(Jt(f,Go,ke),Jt(f,"top",Qe),Jt(f,ul,B),Jt(f,hl,de),Jt(p,Go,ke),Jt(p,"top",Qe),Jt(p,ul,B),Jt(p,hl,de),Jt(d,ul,Fe),Jt(d,hl,Ze),h.width=An(Fe*It),h.height=An(Ze*It),w.forEach(({_el:E,_show:I,_size:O,_pos:F,side:X})=>{if(E!=null)if(I){let K=X===3||X===0?O:0,le=X%2==1;Jt(E,le?"left":"top",F-K),Jt(E,le?"width":"height",O),Jt(E,le?"top":"left",le?Qe:ke),Jt(E,le?"height":"width",le?de:B),ep(E,Fr)}else mi(E,Fr)}),$r=Us=Xr=$=Q=Z=j=Ce=L=null,Ie=1,la(!0),ke!=ye||Qe!=Et||B!=ze||de!=Ye){ft(!1);let E=B/ze,I=de/Ye;if(he&&!ne&&fe.left>=0){fe.left*=E,fe.top*=I,Yr&&os(Yr,An(fe.left),0,B,de),Zr&&os(Zr,0,An(fe.top),B,de);for(let O=0;O<ht.length;O++){let F=ht[O];F!=null&&(Xt[O]*=E,Gn[O]*=I,os(F,Ei(Xt[O]),Ei(Gn[O]),B,de))}}if(Yt.show&&!re&&Yt.left>=0&&Yt.width>0){Yt.left*=E,Yt.width*=E,Yt.top*=I,Yt.height*=I;for(let O in Hh)Jt(Jr,O,Yt[O])}ye=ke,Et=Qe,ze=B,Ye=de}Rn("setSize"),ve=!1}Fe>0&&Ze>0&&(u.clearRect(0,0,h.width,h.height),Rn("drawClear"),b.forEach(E=>E()),Rn("draw")),Yt.show&&re&&(Al(Yt),re=!1),he&&ne&&(_r(null,!0,!1),ne=!1),pe.show&&pe.live&&ge&&(Vh(),ge=!1),l||(l=!0,i.status=1,Rn("ready")),Os=!1,sn=!1}i.redraw=(E,I)=>{Me=I||!1,E!==!1?Bs(M,C.min,C.max):Un()};function Fh(E,I){let O=S[E];if(O.from==null){if(nn==0){let F=O.range(i,I.min,I.max,E);I.min=F[0],I.max=F[1]}if(I.min>I.max){let F=I.min;I.min=I.max,I.max=F}if(nn>1&&I.min!=null&&I.max!=null&&I.max-I.min<1e-16)return;E==M&&O.distr==2&&nn>0&&(I.min=Vi(I.min,e[0]),I.max=Vi(I.max,e[0]),I.min==I.max&&I.max++),z[E]=I,ae=!0,Un()}}i.setScale=Fh;let Bh,zh,Yr,Zr,tm,nm,jr,Kr,im,sm,qt,Qt,Fs=!1,Dn=fe.drag,Tn=Dn.x,Cn=Dn.y;he&&(fe.x&&(Bh=Ai(jC,p)),fe.y&&(zh=Ai(KC,p)),C.ori==0?(Yr=Bh,Zr=zh):(Yr=zh,Zr=Bh),qt=fe.left,Qt=fe.top);let Yt=i.select=yn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Jr=Yt.show?Ai(ZC,Yt.over?p:f):null;function Al(E,I){if(Yt.show){for(let O in E)Yt[O]=E[O],O in Hh&&Jt(Jr,O,E[O]);I!==!1&&Rn("setSelect")}}i.setSelect=Al;function bb(E){if(_[E].show)ee&&ep(ot[E],Fr);else if(ee&&mi(ot[E],Fr),he){let O=Pe?ht[0]:ht[E];O!=null&&os(O,-10,-10,B,de)}}function Bs(E,I,O){Fh(E,{min:I,max:O})}function Xi(E,I,O,F){I.focus!=null&&Eb(E),I.show!=null&&_.forEach((X,K)=>{K>0&&(E==K||E==null)&&(X.show=I.show,bb(K),s==2?(Bs(X.facets[0].scale,null,null),Bs(X.facets[1].scale,null,null)):Bs(X.scale,null,null),Un())}),O!==!1&&Rn("setSeries",E,I),F&&ca("setSeries",i,E,I)}i.setSeries=Xi;function Sb(E,I){yn(A[E],I)}function wb(E,I){E.fill=wt(E.fill||null),E.dir=Ct(E.dir,-1),I=I??A.length,A.splice(I,0,E)}function Mb(E){E==null?A.length=0:A.splice(E,1)}i.addBand=wb,i.setBand=Sb,i.delBand=Mb;function Ab(E,I){_[E].alpha=I,he&&ht[E]!=null&&(ht[E].style.opacity=I),ee&&ot[E]&&(ot[E].style.opacity=I)}let ds,zs,xr,Qr={focus:!0};function Eb(E){if(E!=xr){let I=E==null,O=Ve.alpha!=1;_.forEach((F,X)=>{if(s==1||X>0){let K=I||X==0||X==E;F._focus=I?null:K,O&&Ab(X,K?1:Ve.alpha)}}),xr=E,O&&Un()}}ee&&it&&vt(Hx,be,E=>{fe._lock||(nt(E),xr!=null&&Xi(null,Qr,!0,gn.setSeries))});function qi(E,I,O){let F=S[I];O&&(E=E/It-(F.ori==1?Qe:ke));let X=B;F.ori==1&&(X=de,E=X-E),F.dir==-1&&(E=X-E);let K=F._min,le=F._max,me=E/X,Ae=K+(le-K)*me,De=F.distr;return De==3?$o(10,Ae):De==4?pR(Ae,F.asinh):De==100?F.bwd(Ae):Ae}function Tb(E,I){let O=qi(E,M,I);return Vi(O,e[0],ln,cn)}i.valToIdx=E=>Vi(E,e[0]),i.posToIdx=Tb,i.posToVal=qi,i.valToPos=(E,I,O)=>S[I].ori==0?r(E,S[I],O?q:B,O?k:0):o(E,S[I],O?ce:de,O?R:0),i.setCursor=(E,I,O)=>{qt=E.left,Qt=E.top,_r(null,I,O)};function rm(E,I){Jt(Jr,Go,Yt.left=E),Jt(Jr,ul,Yt.width=I)}function om(E,I){Jt(Jr,"top",Yt.top=E),Jt(Jr,hl,Yt.height=I)}let oa=C.ori==0?rm:om,aa=C.ori==1?rm:om;function Cb(){if(ee&&pe.live)for(let E=s==2?1:0;E<_.length;E++){if(E==0&&ct)continue;let I=pe.values[E],O=0;for(let F in I)We[E][O++].firstChild.nodeValue=I[F]}}function Vh(E,I){if(E!=null&&(E.idxs?E.idxs.forEach((O,F)=>{te[F]=O}):_R(E.idx)||te.fill(E.idx),pe.idx=te[0]),ee&&pe.live){for(let O=0;O<_.length;O++)(O>0||s==1&&!ct)&&Rb(O,te[O]);Cb()}ge=!1,I!==!1&&Rn("setLegend")}i.setLegend=Vh;function Rb(E,I){let O=_[E],F=E==0&&D==2?ii:e[E],X;ct?X=O.values(i,E,I)??et:(X=O.value(i,I==null?null:F[I],E,I),X=X==null?et:{_:X}),pe.values[E]=X}function _r(E,I,O){im=qt,sm=Qt,[qt,Qt]=fe.move(i,qt,Qt),fe.left=qt,fe.top=Qt,he&&(Yr&&os(Yr,An(qt),0,B,de),Zr&&os(Zr,0,An(Qt),B,de));let F,X=ln>cn;ds=Ht,zs=null;let K=C.ori==0?B:de,le=C.ori==1?B:de;if(qt<0||nn==0||X){F=fe.idx=null;for(let me=0;me<_.length;me++){let Ae=ht[me];Ae!=null&&os(Ae,-10,-10,B,de)}it&&Xi(null,Qr,!0,E==null&&gn.setSeries),pe.live&&(te.fill(F),ge=!0)}else{let me,Ae,De;s==1&&(me=C.ori==0?qt:Qt,Ae=qi(me,M),F=fe.idx=Vi(Ae,e[0],ln,cn),De=U(e[0][F],C,K,0));let Oe=-10,Be=-10,ut=0,Rt=0,Tt=!0,yt="",tt="";for(let qe=s==2?1:0;qe<_.length;qe++){let Zt=_[qe],rn=te[qe],Pn=rn==null?null:s==1?e[qe][rn]:e[qe][1][rn],zt=fe.dataIdx(i,qe,F,Ae),on=zt==null?null:s==1?e[qe][zt]:e[qe][1][zt];if(ge=ge||on!=Pn||zt!=rn,te[qe]=zt,qe>0&&Zt.show){let si=zt==null?-10:zt==F?De:U(s==1?e[0][zt]:e[qe][0][zt],C,K,0),Wn=on==null?-10:N(on,s==1?S[Zt.scale]:S[Zt.facets[1].scale],le,0);if(it&&on!=null){let yi=C.ori==1?qt:Qt,Ri=En(Ve.dist(i,qe,zt,Wn,yi));if(Ri<ds){let Yi=Ve.bias;if(Yi!=0){let ri=qi(yi,Zt.scale),vi=on>=0?1:-1,Pi=ri>=0?1:-1;Pi==vi&&(Pi==1?Yi==1?on>=ri:on<=ri:Yi==1?on<=ri:on>=ri)&&(ds=Ri,zs=qe)}else ds=Ri,zs=qe}}if(ge||Pe){let yi,Ri;C.ori==0?(yi=si,Ri=Wn):(yi=Wn,Ri=si);let Yi,ri,vi,Pi,Zi,$n,oi=!0,yr=ue.bbox;if(yr!=null){oi=!1;let Xn=yr(i,qe);vi=Xn.left,Pi=Xn.top,Yi=Xn.width,ri=Xn.height}else vi=yi,Pi=Ri,Yi=ri=ue.size(i,qe);if($n=ue.fill(i,qe),Zi=ue.stroke(i,qe),Pe)qe==zs&&ds<=Ve.prox&&(Oe=vi,Be=Pi,ut=Yi,Rt=ri,Tt=oi,yt=$n,tt=Zi);else{let Xn=ht[qe];Xn!=null&&(Xt[qe]=vi,Gn[qe]=Pi,jx(Xn,Yi,ri,oi),Yx(Xn,$n,Zi),os(Xn,Ei(vi),Ei(Pi),B,de))}}}}if(Pe){let qe=Ve.prox,Zt=xr==null?ds<=qe:ds>qe||zs!=xr;if(ge||Zt){let rn=ht[0];rn!=null&&(Xt[0]=Oe,Gn[0]=Be,jx(rn,ut,Rt,Tt),Yx(rn,yt,tt),os(rn,Ei(Oe),Ei(Be),B,de))}}}if(Yt.show&&Fs)if(E!=null){let[me,Ae]=gn.scales,[De,Oe]=gn.match,[Be,ut]=E.cursor.sync.scales,Rt=E.cursor.drag;if(Tn=Rt._x,Cn=Rt._y,Tn||Cn){let{left:Tt,top:yt,width:tt,height:qe}=E.select,Zt=E.scales[Be].ori,rn=E.posToVal,Pn,zt,on,si,Wn,yi=me!=null&&De(me,Be),Ri=Ae!=null&&Oe(Ae,ut);yi&&Tn?(Zt==0?(Pn=Tt,zt=tt):(Pn=yt,zt=qe),on=S[me],si=U(rn(Pn,Be),on,K,0),Wn=U(rn(Pn+zt,Be),on,K,0),oa(Gi(si,Wn),En(Wn-si))):oa(0,K),Ri&&Cn?(Zt==1?(Pn=Tt,zt=tt):(Pn=yt,zt=qe),on=S[Ae],si=N(rn(Pn,ut),on,le,0),Wn=N(rn(Pn+zt,ut),on,le,0),aa(Gi(si,Wn),En(Wn-si))):aa(0,le)}else Wh()}else{let me=En(im-tm),Ae=En(sm-nm);if(C.ori==1){let ut=me;me=Ae,Ae=ut}Tn=Dn.x&&me>=Dn.dist,Cn=Dn.y&&Ae>=Dn.dist;let De=Dn.uni;De!=null?Tn&&Cn&&(Tn=me>=De,Cn=Ae>=De,!Tn&&!Cn&&(Ae>me?Cn=!0:Tn=!0)):Dn.x&&Dn.y&&(Tn||Cn)&&(Tn=Cn=!0);let Oe,Be;Tn&&(C.ori==0?(Oe=jr,Be=qt):(Oe=Kr,Be=Qt),oa(Gi(Oe,Be),En(Be-Oe)),Cn||aa(0,le)),Cn&&(C.ori==1?(Oe=jr,Be=qt):(Oe=Kr,Be=Qt),aa(Gi(Oe,Be),En(Be-Oe)),Tn||oa(0,K)),!Tn&&!Cn&&(oa(0,0),aa(0,0))}if(Dn._x=Tn,Dn._y=Cn,E==null){if(O){if(xm!=null){let[me,Ae]=gn.scales;gn.values[0]=me!=null?qi(C.ori==0?qt:Qt,me):null,gn.values[1]=Ae!=null?qi(C.ori==1?qt:Qt,Ae):null}ca(Xf,i,qt,Qt,B,de,F)}if(it){let me=O&&gn.setSeries,Ae=Ve.prox;xr==null?ds<=Ae&&Xi(zs,Qr,!0,me):ds>Ae?Xi(null,Qr,!0,me):zs!=xr&&Xi(zs,Qr,!0,me)}}ge&&(pe.idx=F,Vh()),I!==!1&&Rn("setCursor")}let Vs=null;Object.defineProperty(i,"rect",{get(){return Vs==null&&la(!1),Vs}});function la(E=!1){E?Vs=null:(Vs=p.getBoundingClientRect(),Rn("syncRect",Vs))}function am(E,I,O,F,X,K,le){fe._lock||Fs&&E!=null&&E.movementX==0&&E.movementY==0||(Gh(E,I,O,F,X,K,le,!1,E!=null),E!=null?_r(null,!0,!0):_r(I,!0,!1))}function Gh(E,I,O,F,X,K,le,me,Ae){if(Vs==null&&la(!1),nt(E),E!=null)O=E.clientX-Vs.left,F=E.clientY-Vs.top;else{if(O<0||F<0){qt=-10,Qt=-10;return}let[De,Oe]=gn.scales,Be=I.cursor.sync,[ut,Rt]=Be.values,[Tt,yt]=Be.scales,[tt,qe]=gn.match,Zt=I.axes[0].side%2==1,rn=C.ori==0?B:de,Pn=C.ori==1?B:de,zt=Zt?K:X,on=Zt?X:K,si=Zt?F:O,Wn=Zt?O:F;if(Tt!=null?O=tt(De,Tt)?a(ut,S[De],rn,0):-10:O=rn*(si/zt),yt!=null?F=qe(Oe,yt)?a(Rt,S[Oe],Pn,0):-10:F=Pn*(Wn/on),C.ori==1){let yi=O;O=F,F=yi}}Ae&&(I==null||I.cursor.event.type==Xf)&&((O<=1||O>=B-1)&&(O=Or(O,B)),(F<=1||F>=de-1)&&(F=Or(F,de))),me?(tm=O,nm=F,[jr,Kr]=fe.move(i,O,F)):(qt=O,Qt=F)}let Hh={width:0,height:0,left:0,top:0};function Wh(){Al(Hh,!1)}let lm,cm,um,hm;function dm(E,I,O,F,X,K,le){Fs=!0,Tn=Cn=Dn._x=Dn._y=!1,Gh(E,I,O,F,X,K,le,!0,!1),E!=null&&(vt(qf,Jf,fm,!1),ca(Vx,i,jr,Kr,B,de,null));let{left:me,top:Ae,width:De,height:Oe}=Yt;lm=me,cm=Ae,um=De,hm=Oe}function fm(E,I,O,F,X,K,le){Fs=Dn._x=Dn._y=!1,Gh(E,I,O,F,X,K,le,!1,!0);let{left:me,top:Ae,width:De,height:Oe}=Yt,Be=De>0||Oe>0,ut=lm!=me||cm!=Ae||um!=De||hm!=Oe;if(Be&&ut&&Al(Yt),Dn.setScale&&Be&&ut){let Rt=me,Tt=De,yt=Ae,tt=Oe;if(C.ori==1&&(Rt=Ae,Tt=Oe,yt=me,tt=De),Tn&&Bs(M,qi(Rt,M),qi(Rt+Tt,M)),Cn)for(let qe in S){let Zt=S[qe];qe!=M&&Zt.from==null&&Zt.min!=Ht&&Bs(qe,qi(yt+tt,qe),qi(yt,qe))}Wh()}else fe.lock&&(fe._lock=!fe._lock,_r(I,!0,E!=null));E!=null&&(we(qf,Jf),ca(qf,i,qt,Qt,B,de,null))}function Pb(E,I,O,F,X,K,le){if(fe._lock)return;nt(E);let me=Fs;if(Fs){let Ae=!0,De=!0,Oe=10,Be,ut;C.ori==0?(Be=Tn,ut=Cn):(Be=Cn,ut=Tn),Be&&ut&&(Ae=qt<=Oe||qt>=B-Oe,De=Qt<=Oe||Qt>=de-Oe),Be&&Ae&&(qt=qt<jr?0:B),ut&&De&&(Qt=Qt<Kr?0:de),_r(null,!0,!0),Fs=!1}qt=-10,Qt=-10,te.fill(null),_r(null,!0,!0),me&&(Fs=me)}function pm(E,I,O,F,X,K,le){fe._lock||(nt(E),ra(),Wh(),E!=null&&ca(Wx,i,qt,Qt,B,de,null))}function mm(){w.forEach(D2),V(i.width,i.height,!0)}Br(Qu,Wo,mm);let eo={};eo.mousedown=dm,eo.mousemove=am,eo.mouseup=fm,eo.dblclick=pm,eo.setSeries=(E,I,O,F)=>{let X=gn.match[2];O=X(i,I,O),O!=-1&&Xi(O,F,!0,!1)},he&&(vt(Vx,p,dm),vt(Xf,p,am),vt(Gx,p,E=>{nt(E),la(!1)}),vt(Hx,p,Pb),vt(Wx,p,pm),op.add(i),i.syncRect=la);let El=i.hooks=n.hooks||{};function Rn(E,I,O){Hn?Ft.push([E,I,O]):E in El&&El[E].forEach(F=>{F.call(null,i,I,O)})}(n.plugins||[]).forEach(E=>{for(let I in E.hooks)El[I]=(El[I]||[]).concat(E.hooks[I])});let gm=(E,I,O)=>O,gn=yn({key:null,setSeries:!1,filters:{pub:t_,sub:t_},scales:[M,_[1]?_[1].scale:null],match:[n_,n_,gm],values:[null,null]},fe.sync);gn.match.length==2&&gn.match.push(gm),fe.sync=gn;let xm=gn.key,$h=J_(xm);function ca(E,I,O,F,X,K,le){gn.filters.pub(E,I,O,F,X,K,le)&&$h.pub(E,I,O,F,X,K,le)}$h.sub(i);function Ib(E,I,O,F,X,K,le){gn.filters.sub(E,I,O,F,X,K,le)&&eo[E](null,I,O,F,X,K,le)}i.pub=Ib;function Lb(){$h.unsub(i),op.delete(i),dn.clear(),tp(Qu,Wo,mm),c.remove(),be?.remove(),Rn("destroy")}i.destroy=Lb;function Xh(){Rn("init",n,e),sa(e||n.data,!1),z[M]?Fh(M,z[M]):ra(),re=Yt.show&&(Yt.width>0||Yt.height>0),ne=ge=!0,V(n.width,n.height)}return _.forEach(Wr),w.forEach(ls),t?t instanceof HTMLElement?(t.appendChild(c),Xh()):t(i,Xh):Xh(),i}hn.assign=yn;hn.fmtNum=fp;hn.rangeNum=eh;hn.rangeLog=ih;hn.rangeAsinh=hp;hn.orient=Vr;hn.pxRatio=It;hn.join=AR;hn.fmtDate=mp,hn.tzDate=OR;hn.sync=J_;{hn.addGap=_2,hn.clipGaps=oh;let n=hn.paths={points:sy};n.linear=oy,n.stepped=b2,n.bars=S2,n.spline=M2}var k2=20,[O2,uy,uh]=[46,14,4],hy=18,hh=26,U2=16,dh=12;function dy(n,{name:e,lines:t,word:i="",under:s=()=>[],over:r=()=>[],lookOf:o=Fi}){return C0(()=>{let a=n.data.slice(1).map((m,g)=>o(g)),[l,c]=[n.bbox.width/devicePixelRatio,n.bbox.height/devicePixelRatio],h=k2+n.axes[1]._size,u=h+l+uy,d=F2(i,t,a,h,u-uy),f=d.height+8,p=[...s(),...B2(n,l,c),{kind:"clip",x:0,y:0,width:l,height:c,shapes:z2(n,a)},{kind:"path",points:[[0,0],[0,c],[l,c]],stroke:_t("--ink")},...r(),...V2(n,e,l,c,h)],x=f+c+O2;return{svg:ku([...d.shapes,{kind:"moved",x:h,y:f,shapes:p}],u,x,e),width:u,height:x}})}function F2(n,e,t,i,s){let r=document.createElement("canvas").getContext("2d");r.font=`${dh}px system-ui, sans-serif`;let o=[],[a,l]=[i,hy-4],c=_t("--ink"),h=(u,d)=>{let f=d+r.measureText(u).width;a>i&&a+f>s&&([a,l]=[i,l+hy]);let p=a;return a+=f+U2,p};n&&o.push({kind:"text",x:h(n,0),y:l,text:n,size:dh,fill:c});for(let[u,d]of e.entries()){let f=h(d,hh),{colour:p,dash:x,area:m}=t[u];m?o.push({kind:"rect",x:f,y:l-9,width:hh-6,height:9,fill:p}):o.push({kind:"path",points:[[f,l-4],[f+hh-6,l-4]],stroke:p,lineWidth:1.6,dash:x}),o.push({kind:"text",x:f+hh,y:l,text:d,size:dh,fill:c})}return{shapes:o,height:o.length?l+4:0}}function fh(n,e,t){let{_splits:i,_values:s}=n.axes[e];return i.flatMap((r,o)=>s[o]?[[n.valToPos(r,t),s[o]]]:[])}function B2(n,e,t){let i=(...s)=>({kind:"path",points:s,stroke:_t("--grid")});return[...fh(n,0,"x").map(([s])=>i([s,0],[s,t])),...fh(n,1,"y").map(([s])=>i([0,s],[e,s]))]}function z2(n,e){let[t,...i]=n.data;return i.map((s,r)=>{let{colour:o,dash:a,area:l}=e[r],c=[];for(let d=0;d<t.length;d++)s[d]===null||s[d]===void 0||Number.isNaN(s[d])||c.push([n.valToPos(t[d],"x"),n.valToPos(s[d],"y")]);if(!l||!c.length)return{kind:"path",points:c,stroke:o,lineWidth:1.6,dash:a};let h=n.valToPos(0,"y"),u=[c.at(-1),c[0]].map(([d])=>[d,h]);return{kind:"path",points:[...c,...u],fill:o,stroke:_t("--page"),lineWidth:.5}})}function V2(n,e,t,i,s){let[r,o]=[_t("--ink"),_t("--ink")],a=(c,h,u,d)=>({kind:"text",x:c,y:h,text:u,size:dh,fill:r,...d}),{label:l}=n.axes[0];return[...fh(n,0,"x").flatMap(([c,h])=>[{kind:"path",points:[[c,i],[c,i+uh]],stroke:o},a(c,i+uh+13,h,{anchor:"middle"})]),...fh(n,1,"y").flatMap(([c,h])=>[{kind:"path",points:[[0,c],[-uh,c]],stroke:o},a(-uh-4,c+4,h,{anchor:"end"})]),a(t/2,i+38,typeof l=="function"?l():l,{anchor:"middle"}),a(12-s,i/2,Nt(e),{anchor:"middle",turned:!0})]}var xh=210,G2=64,H2=.02,W2=[.01,.02,.05,.1,.2,.5,1,2,5,10,15,30,45,90,180,360,...nP(3,20)];function mr(n,e,t,i){let s=e.map(o=>$2(o,t)),r=e.map((o,a)=>{let l=o.sharing?s.filter((c,h)=>e[h].sharing===o.sharing).flat():null;return q2(o,s[a].map(c=>c.values),l,t,i)});n.replaceChildren(...r.map(o=>o.element)),n.classList.add("plots");for(let o of r)o.start();return{charts:r.map(o=>o.chart),dispose:()=>r.forEach(o=>o.dispose())}}function $2(n,e){return n.lines.map(t=>({clip:t.clip,values:t.readings?e[t.clip].line(t.readings,t.part):Kt(t.values,Float32Array)}))}function X2(n,e,t){let i=[1/0,-1/0];for(let{clip:s,values:r}of n){let o=e[s].time;for(let a=0;a<o.length;a++){let l=o[a]-t.origins[s];l<t.start||l>t.end||(r[a]<i[0]&&(i[0]=r[a]),r[a]>i[1]&&(i[1]=r[a]))}}return i}function ph(n){let[e,...t]=n.lines.map(i=>i.clip);return t.every(i=>i===e)?e??null:null}function q2(n,e,t,i,s){let{element:r,head:o,key:a,place:l}=Sp(n,n.owner),c=v("div",{className:"cursor"}),h=n.ball===void 0?null:v("div",{className:"ball"}),u=null,d=null,f=!1,p=[],x=new ResizeObserver(()=>u?.setSize({width:l.clientWidth,height:xh}));function m(){let{word:A}=n,M=py(n).map((y,b)=>v("li",{},vr(mh(n,b)),y));a.replaceChildren(...A?[v("li",{},A)]:[],...M)}function g(){(s.span!==d||s.stretched!==f)&&(d=s.span,f=s.stretched,u.setData(fy(n,e,i,d),!1),u.setScale("x",{min:d.start,max:d.end}));let A=u.valToPos(s.time,"x").toFixed(2);c.style.transform=`translateX(${A}px)`,h&&(h.style.transform=`translate(${A}px, ${u.valToPos(_(),"y").toFixed(2)}px)`)}function _(){let{clip:A}=n.lines[n.ball];return or(i[A].time,e[n.ball],s.clipTime(A))}function w(){d=s.span,f=s.stretched,u=new hn(j2(n,t,i,s,l.clientWidth),fy(n,e,i,d),l),u.setScale("x",{min:d.start,max:d.end}),u.over.append(c,...h?[h]:[]),tP(u,s),x.observe(l),u.hooks.setSize=[g];let A=()=>{m(),u.redraw(!1)};p=[s.onChange(g),sr(A)],m();let M=ph(n);o.append(wp(n,()=>u,{under:()=>gy(u,i,M,s.span),over:()=>xy(u,i,M,s.span)}))}function S(){for(let A of p)A();x.disconnect(),u.destroy()}return{element:r,start:w,dispose:S,get chart(){return u}}}function Sp(n,e=null){let t=e?`${Nt(e)}. ${n.text}`:n.text,i=v("div",{className:"chart",role:"img","aria-label":t}),s=v("ul",{className:"key"}),r=v("h2",{},`${Nt(n.title)} (${n.unit})`);e&&r.append(v("small",{},e));let o=v("div",{className:"head"},r);return{element:v("figure",{},o,s,i,v("figcaption",{},n.text)),head:o,key:s,place:i}}function py({lines:n,word:e}){return n.map(({name:t})=>e?t.slice(e.length+1):t)}function mh({lines:n,stacked:e},t){let{area:i,look:s}=n[t];return i?{colour:i.startsWith("--")?_t(i):i,dash:[],area:!0}:e?{colour:_t("--ink"),dash:[]}:Fi(s??t)}function wp(n,e,{under:t,over:i}){let s=n.owner?`${n.title}, ${n.owner}`:n.title;return ji(s,()=>qn(s),()=>dy(e(),{name:`${n.title} (${n.unit})`,lines:py(n),word:n.word,under:t,over:i,lookOf:n.stacked?o=>mh(n,o):void 0}))}function fy(n,e,t,i){if(n.stacked)return Y2(n,e,t[n.lines[0].clip],i.origins[n.lines[0].clip]+i.start,i);let s=n.lines.map((r,o)=>[Float64Array.from(t[r.clip].time,a=>a-i.origins[r.clip]),e[o]]);return ph(n)!==null?[s[0]?.[0]??[],...s.map(r=>r[1])]:hn.join(s)}function Y2({lines:n},e,t,i,s){let r=n.map(({since:a},l)=>{let c=a===void 0?0:or(t.time,e[a],i);return Float64Array.from(e[l],h=>h-c)}),o=new Float64Array(t.time.length);for(let a=n.length-1;a>=0;a--)if(n[a].area){for(let l=0;l<o.length;l++)o[l]+=r[a][l];r[a].set(o)}return[Float64Array.from(t.time,a=>a-s.origins[n[0].clip]),...r]}function Z2(n){return n.lines.map(({area:e},t)=>({stroke:()=>e?_t("--page"):mh(n,t).colour,...e?{fill:()=>mh(n,t).colour,fillTo:0}:{},width:e?.5:1.6,points:{show:!1}}))}function j2(n,e,t,i,s){let r=_h(),o=(a,l,c)=>Q2(n,...e?X2(e,t,i.span):[l,c]);return{width:s,height:xh,legend:{show:!1},cursor:{show:!1},padding:[8,10,0,0],scales:{x:{time:!1,auto:!1,distr:100,fwd:i.shareAt,bwd:i.momentAt},y:{range:o}},series:[{},...n.stacked?Z2(n):Mp(n.lines)],axes:[{...r,...Ap,labelFont:r.font,label:()=>`${i.span.label} (${ua(i.span).unit})${i.stretched?", stretched":""}`,filter:(a,l)=>l,splits:(a,l,c,h,u)=>i.stretched?K2(a,i):J2(c,h,u),values:(a,l)=>l.map(c=>c===null?"":my(c*ua(i.span).factor)),space:56},Ep(n)],hooks:{drawClear:[a=>gh(a,gy(a,t,ph(n),i.span))],draw:[a=>gh(a,xy(a,t,ph(n),i.span))]}}}function K2(n,e){let t=Math.max(2,Math.floor(n.bbox.width/devicePixelRatio/G2)),{factor:i}=ua(e.span),s=new Set;for(let r=0;r<=t;r++){let o=e.momentAt(r/t),a=[1,2,3,4,5,6].map(c=>Number((i*o).toPrecision(c))/i),l=c=>Math.abs(e.shareAt(c)-r/t)<.2/t;s.add(a.find(l)??a[a.length-1])}return[...s].filter(r=>r>=e.span.start&&r<=e.span.end)}function J2(n,e,t){let i=Math.ceil(n/t-1e-9);return Array.from({length:Math.floor(e/t+1e-9)-i+1},(s,r)=>(i+r)*t)}function Mp(n){return n.map(({look:e},t)=>({stroke:()=>Fi(e??t).colour,dash:Fi(e??t).dash,width:1.6,points:{show:!1},spanGaps:!0}))}var Ap={size:24,gap:3,labelSize:18,labelGap:0};function _h(){return{stroke:()=>_t("--muted"),grid:{stroke:()=>_t("--grid"),width:1},ticks:{stroke:()=>_t("--grid"),width:1,size:4},font:"12px system-ui, sans-serif"}}function Ep(n){return{..._h(),size:(e,t)=>Math.max(48,16+7*Math.max(0,...(t??[]).map(i=>i.length))),gap:3,values:(e,t)=>t.map(i=>i===null?"":my(i)),...n.unit==="deg"?{incrs:W2,space:26}:{space:30}}}function Q2(n,e,t){let[i,s]=eP(e,t)?[e,t]:[Math.min(0,e??0),Math.max(0,t??0)],r=.06*(s-i||1);return[n.unit==="deg"||i!==0?i-r:i,s+2*r]}function eP(n,e){let t=Math.max(Math.abs(n),Math.abs(e));return n*e>0&&Math.min(Math.abs(n),Math.abs(e))>t/2&&e-n>H2*t}function my(n){let e=Math.abs(n)<1e-12?"0":String(Number(n.toPrecision(6)));return e.length>7?Mt(n):e.replace("-","−")}function gh(n,e){let{ctx:t,bbox:i}=n;sl(t,e,devicePixelRatio,[i.left/devicePixelRatio,i.top/devicePixelRatio])}function gy(n,e,t,i){if(t===null)return[];let[s,r]=[n.bbox.width/devicePixelRatio,n.bbox.height/devicePixelRatio];return e[t].stages.filter(o=>o.driven).map(o=>{let[a,l]=[o.start,o.end].map(c=>Math.min(s,Math.max(0,n.valToPos(c-i.origins[t],"x"))));return{kind:"rect",x:a,y:0,width:l-a,height:r,fill:_t("--band")}})}function xy(n,e,t,i){if(t===null)return[];let[s,r]=[n.bbox.width/devicePixelRatio,n.bbox.height/devicePixelRatio];return e[t].marks.flatMap(o=>{let a=n.valToPos(o.time-i.origins[t],"x");if(a<-1||a>s+1)return[];let l=a>s-16?-1:1;return[{kind:"path",points:[[a,0],[a,r]],stroke:_t("--muted"),dash:[2,3]},{kind:"rect",x:a+(l>0?2:-14),y:1,width:12,height:15,fill:_t("--page")},{kind:"text",x:a+l*8,y:13,text:o.letter,anchor:"middle",bold:!0,fill:_t("--ink")}]})}function tP(n,e){Tp(n,t=>{e.pause(),e.seek(n.posToVal(t.clientX-n.over.getBoundingClientRect().left,"x"))})}function Tp(n,e){n.over.addEventListener("pointerdown",t=>{t.button===0&&(n.over.setPointerCapture(t.pointerId),e(t))}),n.over.addEventListener("pointermove",t=>{n.over.hasPointerCapture(t.pointerId)&&e(t)})}function nP(n,e){return Array.from({length:e-n},(t,i)=>[1,2,5].map(s=>s*10**(n+i))).flat()}function yh(n,e){if(matchMedia("(prefers-reduced-motion: reduce)").matches)return;let t=new IntersectionObserver(i=>{i.some(s=>s.isIntersecting)&&(t.disconnect(),e.play())},{threshold:.3});t.observe(n.querySelector(".picture")??n),n.addEventListener("pointerdown",()=>t.disconnect(),{once:!0})}function _y(n){let e=n.clips.map(Kn),t=Bi(e,n.spans),i=ur(document.getElementById("player"),e,t,n);Cp(i.stage.cells,e,t,n.energy);let s=mr(document.getElementById("plots"),n.plots,e,t);return yh(document.getElementById("player"),t),{clips:e,clock:t,player:i,plots:s}}function Cp(n,e,t,i){let s=e.map((r,o)=>{let a=v("span",{className:"state-now"}),l=v("b",{},vr(Fi(o)),r.name);return sr(()=>l.replaceChild(vr(Fi(o)),l.firstChild)),n[o].append(l,a),a});t.onChange(()=>{for(let[r,o]of e.entries()){let a=t.clipTime(r),c=[t.time+t.span.origins[r]>o.end?"ended":o.stageAt(a).name],[h]=o.readings;h&&c.push(iP(o.valuesAt(h.name,a),h.unit));let u=o.valuesAt(Is,a).reduce((d,f)=>d+f,0);o.tendons&&c.push(`${Mt(i.factor*u)} ${i.unit}`),s[r].textContent=c.join(" · ")}})}function iP(n,e){let t=s=>e==="deg"?`${kn(s,0)}°`:`${Mt(s)} ${e}`,i=[Math.min(...n),Math.max(...n)].map(t);return i[0]===i[1]?i[0]:i.join(" to ")}function Rp(n){return n.energy?Oo:T0}function yy(n,e){let t=n.at(e).map(s=>Math.round(255*s)),i=.299*t[0]+.587*t[1]+.114*t[2]>118;return{face:`rgb(${t.join(" ")})`,ink:i?"#000":"#fff"}}function Jo({sign:n,pattern:e}){return v("span",{className:`what ${e}`,"aria-hidden":"true"},v("span",{},n))}function vh(n,e){let t=n.scaleOf(e);if(!t)return[];let i=v("span",{className:"bar","aria-hidden":"true"});return i.style.background=Rp(e).gradient,[v("p",{className:"scale"},`${e.title} (${e.unit})`,v("span",{className:"whole"},t.text(t.low),i,t.text(t.high)))]}function bh(n,e){let{factors:t,quantities:i,words:s}=n,r=t.map(u=>u.values.length),o=new Map;for(let u of e)o.set(u.point,[...o.get(u.point)??[],u]);function a(u){if(n.sampled)return t.map(()=>u);let d=[];for(let f=r.length-1;f>=0;f--)d[f]=u%r[f],u=Math.floor(u/r[f]);return d}let l=u=>u.reduce((d,f,p)=>d*r[p]+f,0);function c(u){let f=(u.shares?i.filter(_=>_.group===u.group):[u]).flatMap(_=>_.values??[]).filter(_=>_!==null);if(!f.length)return null;let[p,x]=[f.reduce((_,w)=>Math.min(_,w)),f.reduce((_,w)=>Math.max(_,w))],m=_=>x>p?(_-p)/(x-p):.5,g=sP((u.values??[]).filter(_=>_!==null));return{low:p,high:x,colour:_=>yy(Rp(u),m(_)),text:_=>as(Number(_.toFixed(g)))}}let h=(u,d)=>`${u.name} ${u.texts[d]}${u.unit?` ${u.unit}`:""}`;return{study:n,sizes:r,numbers:i.filter(u=>u.values&&!u.tried),columns:t,shown:()=>!0,nameOf:()=>"",placesOf:a,pointAt:l,scaleOf:c,factorText:h,largestSpan:e.reduce((u,d)=>Math.max(u,d.play.clips[0].span_m),0),runsOf:u=>o.get(u)??[],word:u=>s[u],pointText:u=>a(u).map((d,f)=>h(t[f],d)).join(", "),valueText(u,d){let f=u.values?.[d]??null;return f===null?s[u.reasons[d]].word:`${as(f)} ${u.unit}`}}}function sP(n){let e=n.reduce((t,i)=>Math.max(t,Math.abs(i)),0);return Math.min(20,Math.max(0,2-Math.floor(Math.log10(e||1))))}function as(n){let e=Number(n.toPrecision(3));return(e!==0&&Math.abs(e)<.001?e.toExponential():String(e)).replaceAll("-","−")}var rP="http://www.w3.org/2000/svg";function Lt(n,e,...t){let i=document.createElementNS(rP,n);for(let[s,r]of Object.entries(e))i.setAttribute(s,r);return i.append(...t),i}function Qo({values:n,log:e},t=[]){let i=[...new Set(n.filter(d=>typeof d=="string"))];if(i.length)return{words:i,share:f=>(i.indexOf(f)+.5)/i.length,ticks:i,value:f=>i[Math.min(i.length-1,Math.max(0,Math.floor(f*i.length)))]};let s=[...n,...t].filter(d=>typeof d=="number"),r=e&&s.every(d=>d>0),[o,a]=r?[Math.log,Math.exp]:[d=>d,d=>d],l=s.reduce((d,f)=>Math.min(d,o(f)),1/0),c=s.reduce((d,f)=>Math.max(d,o(f)),-1/0),h=d=>c>l?(o(d)-l)/(c-l):.5,u=s.length?(r?oP:vy)(a(l),a(c)):[];return{words:i,share:h,ticks:u,value:d=>a(l+d*(c-l))}}function Pp(n,e,t,i,s=[]){let r=e.unit?`${e.name} (${e.unit})`:e.name,o=Qo({values:n,log:e.log},s),a=.04*(i-t),l=h=>t+a+o.share(h)*(i-t-2*a),c=o.ticks.map(h=>[l(h),typeof h=="number"?as(h):h]);return{label:r,from:t,to:i,ticks:c,at:l,place:h=>n[h]===null?t+.75*a:l(n[h])}}function vy(n,e){if(!(e>n))return[n];let t=(e-n)/5,i=10**Math.floor(Math.log10(t)),s=i*([1,2,5].find(o=>o*i>=t)??10),r=[];for(let o=Math.ceil(n/s)*s;o<=e+1e-9*s;o+=s)r.push(Number(o.toPrecision(12)));return r}function oP(n,e){if(!(e>n))return[n];let t=e/n>200?[1]:[1,2,5],i=[];for(let s=Math.floor(Math.log10(n));s<=Math.ceil(Math.log10(e));s++)for(let r of t){let o=Number((r*10**s).toPrecision(12));o>=n*(1-1e-9)&&o<=e*(1+1e-9)&&i.push(o)}return i.length>1?i:vy(n,e)}function by(n,e,t){let i=[Lt("path",{class:"axis",d:`M${n.from} ${e.to}V${e.from}H${n.to}`})],s=(r,o)=>i.push(Lt("text",{class:"label",...o},r));for(let[r,o]of n.ticks)s(o,{x:r,y:e.from+18,"text-anchor":"middle"});for(let[r,o]of e.ticks)s(o,{x:n.from-8,y:r,dy:"0.35em","text-anchor":"end"});return s(n.label,{x:(n.from+n.to)/2,y:t-8,"text-anchor":"middle"}),s(e.label,{transform:`translate(14 ${(e.from+e.to)/2}) rotate(-90)`,"text-anchor":"middle"}),i}var Sh=300,Sy=30,aP=92,Ay=16,lP=5;function Ey(n,e,{best:t,best_word:i,front:s},r){let a={axes:[...new Set(e.map(n.indexOf).filter(y=>y>=0))],opened:null,hovered:null,best:t,bestWord:i,front:s},l=v("div",{className:"titles"}),c=v("div",{className:"drawn"}),h=v("div",{className:"board"},l,c),u=v("div",{className:"scroll"},h),d=v("p",{className:"note",role:"status"}),f=v("p",{className:"note under"}," "),p=v("button",{type:"button"},`show all ${n.study.noun}s`);p.addEventListener("click",()=>{n.forget(),c.querySelector("[role=slider]")?.focus()});let x=()=>{hP(n,a,{board:h,titles:l,place:c,width:u.clientWidth}),wh(n,a,c)},m="Press a line to open its run. Move the two handles of an axis to select a range of values.",g=uP(n,a),_=`All ${n.study.noun}s as lines`,w=ji(_,()=>qn(_),()=>cr([h,g],_,".handle")),S=v("div",{className:"head"},v("h2",{},_),w),A=v("section",{className:"lines"},S,v("p",{className:"note"},m),cP(n,a,x),u,g,v("div",{className:"choices"},p,d),f);gP(n,a,c,f,r),n.whenAsked(()=>{wh(n,a,c),Ty(n,a,c),wy(n,d,p)}),wy(n,d,p);let M=0;return new ResizeObserver(()=>{u.clientWidth!==M&&(M=u.clientWidth,x())}).observe(u),{element:A,show(y){a.opened=y,wh(n,a,c)}}}function wy(n,e,t){let{points:i,noun:s}=n.study,r=Array.from({length:i},(l,c)=>c).filter(n.shown),o=r.filter(n.good).length,a=n.study.words.find(l=>l.good)?.word;e.textContent=`${r.length} of ${i} ${s}s lie within the selected ranges${a?`; ${a}: ${o}`:""}.`,t.hidden=n.asked.size===0}function cP(n,e,t){let i=n.columns.map((s,r)=>{let o=v("input",{type:"checkbox",checked:e.axes.includes(r)});return o.addEventListener("change",()=>{e.axes=n.columns.map((a,l)=>l).filter(a=>a===r?o.checked:e.axes.includes(a)),o.checked||n.ask(r,0,1),t()}),v("label",{},o,s.name)});return v("details",{},v("summary",{},"Axes"),v("fieldset",{className:"filter"},v("legend",{},"Show an axis of"),...i))}function uP(n,e){let t=(r,o)=>v("li",{},v("span",{className:`line ${r}`,"aria-hidden":"true"}),o),i=n.study.words.find(r=>r.good),s=[];return i&&s.push(t("good",i.word)),n.study.words.some(r=>!r.good)&&s.push(t("behind",i?`other ${n.study.noun}s`:`all ${n.study.noun}s`)),e.front.length&&s.push(t("front","Pareto front")),e.best!==null&&s.push(t("best",e.bestWord)),s.push(t("opened","open")),n.columns.some(r=>r.limits.length)&&s.push(v("li",{},v("span",{className:"bound","aria-hidden":"true"}),"range allowed by a limit")),v("ul",{className:"keys-of-lines"},...s)}function hP(n,e,{board:t,titles:i,place:s,width:r}){let o=e.axes.length,a=Math.max(r,o*aP);t.style.width=`${a}px`,i.replaceChildren(...e.axes.map(c=>dP(n.columns[c]))),i.style.gridTemplateColumns=`repeat(${o}, 1fr)`,e.x=c=>(c+.5)*a/o,e.y=c=>Sh-Sy-c*(Sh-2*Sy);let l=Lt("svg",{width:a,height:Sh,viewBox:`0 0 ${a} ${Sh}`,role:"img","aria-label":`${n.study.points} ${n.study.noun}s as lines over ${o} axes; the table below has them all`});l.append(Lt("g",{class:"layers"}));for(let[c,h]of e.axes.entries())l.append(...fP(n.columns[h],e.x(c),e.y));s.replaceChildren(l),Ty(n,e,s)}function dP(n){let e=n.unit?` (${n.unit})`:"",t=n.aim?v("small",{},`${n.aim} is best`):"";return v("div",{},`${n.name}${e}`,t)}function fP({scale:n,limits:e},t,i){let s=[Lt("path",{class:"axis",d:`M${t} ${i(0)}V${i(1)}`})];for(let{kind:r,bound:o}of e){let a=Math.min(1,Math.max(0,n.share(o)));s.push(Lt("path",{class:"bound",d:`M${t} ${i(a)}V${i(r===">="?1:0)}`}))}for(let r of n.ticks){let o=i(n.share(r));s.push(Lt("path",{class:"axis",d:`M${t} ${o}h5`}),Lt("text",{class:"label",x:t+8,y:o,dy:"0.35em"},typeof r=="number"?as(r):r))}return s}function Ty(n,e,t){let i=t.contains(document.activeElement)?document.activeElement.dataset.handle:null;for(let s of t.querySelectorAll("[role=slider]"))s.remove();for(let[s,r]of e.axes.entries())for(let o of["least","most"]){let a=pP(n,e,t,r,o);a.style.left=`${e.x(s)}px`,t.append(a),a.dataset.handle===i&&a.focus()}}function pP(n,e,t,i,s){let r=n.columns[i],[o,a]=n.asked.get(i)??[0,1],l=s==="least"?o:a,c=r.scale.value(l),h=typeof c=="number"?`${as(c)} ${r.unit}`.trim():String(c??""),u=v("div",{role:"slider",className:`handle ${s}`,tabIndex:0,"aria-orientation":"vertical","aria-label":`${s} ${r.name}`,"aria-valuemin":"0","aria-valuemax":"100","aria-valuenow":String(Math.round(100*l)),"aria-valuetext":h,title:`${s} ${r.name}: ${h}`});u.dataset.handle=`${i} ${s}`,u.dataset.keys="own",u.style.top=`${e.y(l)}px`;let d=x=>{let[m,g]=n.asked.get(i)??[0,1];s==="least"?n.ask(i,Math.min(Math.max(x,0),g),g):n.ask(i,m,Math.max(Math.min(x,1),m))},f=r.scale.words.length?1/r.scale.words.length:.02,p={ArrowUp:f,ArrowRight:f,ArrowDown:-f,ArrowLeft:-f,PageUp:5*f,PageDown:-5*f};return u.addEventListener("keydown",x=>{if(!(x.ctrlKey||x.metaKey||x.altKey)){if(x.key in p)d(l+p[x.key]);else if(x.key==="Home")d(0);else if(x.key==="End")d(1);else return;x.preventDefault()}}),u.addEventListener("pointerdown",x=>{x.preventDefault(),u.focus(),Cy(x,m=>d(Ip(e,t,m)))}),u}function Cy(n,e,t=()=>{}){let i=o=>a=>a.pointerId===n.pointerId&&o(a),s=i(e),r=i(o=>{removeEventListener("pointermove",s),removeEventListener("pointerup",r),removeEventListener("pointercancel",r),t(o)});addEventListener("pointermove",s),addEventListener("pointerup",r),addEventListener("pointercancel",r)}function Ip(n,e,t){let i=t.clientY-e.getBoundingClientRect().top;return Math.min(1,Math.max(0,(n.y(0)-i)/(n.y(0)-n.y(1))))}function mP(n,e,t){let i="",s=!1;for(let[r,o]of e.axes.entries()){let a=n.columns[o].values[t];a!==null&&(i+=`${s?"L":"M"}${e.x(r).toFixed(1)} ${e.y(n.columns[o].scale.share(a)).toFixed(1)}`),s=a!==null}return i}function wh(n,e,t){let i=t.querySelector(".layers");if(!i)return;let s=Array.from({length:n.study.points},(h,u)=>u),[r,o]=[s.filter(n.shown),s.filter(h=>!n.shown(h))],a=h=>h===null?[]:[h],l={out:o,behind:r.filter(h=>!n.good(h)),good:r.filter(n.good),front:e.front.filter(n.shown),best:a(e.best),opened:a(e.opened),hovered:a(e.hovered)},c=Object.entries(l).filter(([,h])=>h.length);i.replaceChildren(...c.map(([h,u])=>Lt("path",{class:`line ${h}`,d:u.map(d=>mP(n,e,d)).join("")})))}function gP(n,e,t,i,s){let r=o=>{o!==e.hovered&&(e.hovered=o,t.classList.toggle("pressable",o!==null),i.textContent=o===null?" ":`${n.nameOf(o)}${n.pointText(o)}: ${n.study.statuses[o]}`,wh(n,e,t))};t.addEventListener("pointermove",o=>{o.pointerType==="mouse"&&o.buttons===0&&r(My(n,e,t,o))}),t.addEventListener("pointerleave",()=>r(null)),t.addEventListener("pointerdown",o=>{if(o.button!==0||o.target.closest("[role=slider]"))return;let a=o.pointerType==="touch"?null:xP(e,t,o),l=Ip(e,t,o),c=!1;Cy(o,u=>{c||=Math.hypot(u.clientX-o.clientX,u.clientY-o.clientY)>lP;let d=Ip(e,t,u);c&&a!==null&&n.ask(a,Math.min(l,d),Math.max(l,d))},u=>{let d=c||u.type==="pointercancel"?null:My(n,e,t,u);d!==null&&s(d)})})}function xP(n,e,t){let i=t.clientX-e.getBoundingClientRect().left,s=n.axes.findIndex((r,o)=>Math.abs(n.x(o)-i)<Ay);return s<0?null:n.axes[s]}function My(n,e,t,i){let s=t.getBoundingClientRect(),[r,o]=[i.clientX-s.left,i.clientY-s.top],a=e.axes.findLastIndex((p,x)=>e.x(x)<=r),[l,c]=[Math.max(0,a),Math.min(e.axes.length-1,a+1)],h=c>l?(r-e.x(l))/(e.x(c)-e.x(l)):0,u=(p,x)=>{let m=n.columns[e.axes[p]],g=m.values[x];return g===null?NaN:e.y(m.scale.share(g))},[d,f]=[null,Ay];for(let p=0;p<n.study.points;p++){if(!n.shown(p))continue;let[x,m]=[u(l,p),u(c,p)],g=x+h*(m-x),_=c>l?(m-x)/(e.x(c)-e.x(l)):0,w=Math.abs(o-g)/Math.hypot(1,_)-(n.good(p)?1:0);w<f&&([d,f]=[p,w])}return d}function Ry(n,e){let t=bh(n,e),i=n.factors.map(c=>({...c,limits:[],aim:""})),s=t.numbers.map(c=>({...c,key:c.name,name:c.title,log:!1,own:null})),r=[...i,...s].map(c=>({...c,scale:Qo(c,_P(c))})),o=new Map,a=[],l=([c,[h,u]],d)=>{let f=r[c].values[d];if(f===null)return!1;let p=r[c].scale.share(f);return p>=h-1e-9&&p<=u+1e-9};return{...t,columns:r,asked:o,indexOf:c=>r.findIndex(h=>h.key===c),shown:c=>[...o].every(h=>l(h,c)),good:c=>t.word(n.verdicts[c]).good,nameOf:c=>`${n.noun} ${c+1}: `,whenAsked:c=>a.push(c),ask(c,h,u){h<=0&&u>=1?o.delete(c):o.set(c,[h,u]);for(let d of a)d()},forget(){o.clear();for(let c of a)c()}}}function _P({limits:n,values:e}){let t=e.filter(r=>typeof r=="number"),[i,s]=[Math.min(...t),Math.max(...t)];return n.map(r=>r.bound).filter(r=>r>=i-(s-i)&&r<=s+(s-i))}var yP=12,[Lp,Ds]=[200,76],gl=130;function Ly(n,{marginals:e,pairs:t},i){let s=v("div",{className:"marginals"}),r=v("div",{className:"pairs"}),[o,a]=[e,t].map(u=>u.map(n.indexOf).filter(d=>d>=0)),l=()=>{s.replaceChildren(...o.map(u=>SP(n,u))),r.replaceChildren(...wP(n,a,i))};r.style.setProperty("--columns",Math.max(1,a.length-1)),n.whenAsked(l),l();let h=[Py("Single unknowns",s),v("p",{className:"note"},"Blue: samples that agree. Grey: all drawn samples. Each colour is scaled by its number of samples. Unknowns that the facts narrow most come first."),s];return a.length>1&&h.push(Py("Pairs of unknowns",r),v("p",{className:"note"},"Press a pair to enlarge it."),r),{element:v("section",{className:"agreeing"},...h)}}function Py(n,e){let t=ji(n,()=>qn(n),()=>cr([e],n));return v("div",{className:"head"},v("h2",{},n),t)}var vP=n=>Array.from({length:n.study.points},(e,t)=>t),Ny=n=>vP(n).filter(e=>!["placed","unbuilt"].includes(n.word(n.study.verdicts[e]).pattern));function bP(n,e,t){let i=e.words.length||yP,s=new Array(i).fill(0);for(let r of t)s[Math.min(i-1,Math.floor(e.share(n.values[r])*i))]+=1/t.length;return s}function SP(n,e){let t=n.columns[e],i=Qo(t),s=Ny(n),r=s.filter(m=>n.good(m)&&n.shown(m)),[o,a]=[s,r].map(m=>bP(t,i,m)),l=Math.max(...o,...r.length?a:[0]),c=Lp/o.length,h=(m,g)=>Lt("path",{class:g,d:m.map((_,w)=>`M${w*c+1} ${Ds}v${-_/l*(Ds-4)}h${c-2}V${Ds}z`).join("")}),u=m=>Lt("path",{class:"agree",d:`M0 ${Ds}${m.map((g,_)=>`V${Ds-g/l*(Ds-4)}H${(_+1)*c}`).join("")}V${Ds}`}),d=`${t.name}: ${Iy(t,i,r)}`,f=Lt("svg",{viewBox:`0 0 ${Lp} ${Ds}`,role:"img","aria-label":d,preserveAspectRatio:"none"},h(o,"all"),...r.length?[u(a)]:[],Lt("path",{class:"axis",d:`M0 ${Ds}H${Lp}`})),p=i.words.length?i.words:[0,1].map(m=>as(i.value(m))),x=t.unit?` (${t.unit})`:"";return v("figure",{},v("figcaption",{},`${t.name}${x}`),f,v("div",{className:"ends"},...p.map(m=>v("span",{},m))),v("small",{},Iy(t,i,r)))}function Iy(n,e,t){if(!t.length)return"no sample agrees";if(e.words.length)return e.words.map(r=>`${Math.round(100*t.filter(o=>n.values[o]===r).length/t.length)} % ${r}`).join(", ");let i=t.map(r=>n.values[r]).sort((r,o)=>r-o),s=r=>as(i[Math.round(r*(i.length-1))]);return`middle half: ${s(.25)} to ${s(.75)}`}function wP(n,e,t){return e.slice(1).flatMap((i,s)=>e.slice(0,-1).map((r,o)=>o>s?v("span",{}):MP(n,r,i,t)))}function MP(n,e,t,i){let[s,r]=[e,t].map(f=>n.columns[f]),[o,a]=[s,r].map(f=>Qo(f)),l=(f,p)=>Lt("path",{class:p,d:f.map(x=>`M${(4+o.share(s.values[x])*(gl-8)).toFixed(1)} ${(gl-4-a.share(r.values[x])*(gl-8)).toFixed(1)}h0`).join("")}),c=Ny(n),h=c.filter(f=>n.good(f)&&n.shown(f)),u=Lt("svg",{viewBox:`0 0 ${gl} ${gl}`,"aria-hidden":"true"},l(c.filter(f=>!h.includes(f)),"all"),l(h,"agree")),d=v("button",{type:"button","aria-label":`${r.name} over ${s.name}, large`},u,v("small",{},`${r.name} ↑, ${s.name} →`));return d.addEventListener("click",()=>i(e,t)),d}var[Dy,Np]=[600,420],Mh={left:76,right:14,top:12,bottom:52},ky=60,Oy={ArrowLeft:-1,ArrowUp:-1,ArrowRight:1,ArrowDown:1};function Ah(n,e,t){let{columns:i,study:s}=n,{quantity:r}=e,o=Array.from({length:s.points},(g,_)=>_),a=n.scaleOf(r),l=Pp(i[e.x].values,i[e.x],Mh.left,Dy-Mh.right,e.cells?.across),c=e.y===null?r.values??o.map(()=>0):i[e.y].values,h=e.y===null?{name:r.title,unit:r.unit}:i[e.y],u=Pp(c,h,Np-Mh.bottom,Mh.top,e.cells?.upwards),d=`${r.title} of ${s.points} ${s.noun}s; arrows move between them, enter opens one`,f=Lt("svg",{viewBox:`0 0 ${Dy} ${Np}`,class:["scatter",o.length>ky&&"many",e.ordered&&"judged"].filter(Boolean).join(" "),role:"listbox","aria-label":d});e.cells&&f.append(...TP(e.cells,l,u)),Dp(s,e)&&f.append(...CP(s.boundaries,e,l,u)),f.append(...by(l,u,Np),...Fy(i[e.x],l,u,!0),...e.y===null?[]:Fy(i[e.y],u,l,!1));let p=o.map(g=>[l.place(g),u.place(g)]);e.joined&&f.append(RP(e.front,p,i[e.x].aim));let x=o.length>ky?6:8,m=o.map(g=>EP(n,e,a,g,p[g],x));return f.append(...(e.ordered?AP(n,e,o):o).map(g=>m[g])),(m[e.current??0]??m[0])?.setAttribute("tabindex","0"),PP(f,m,e.ordered?[...o].sort((g,_)=>p[g][0]-p[_][0]):o,t),{element:v("div",{className:"scroll"},f),points:o}}function AP(n,e,t){let i=s=>(n.shown(s)?0:1e6)+(e.best===s?-1:n.study.verdicts[s]);return[...t].sort((s,r)=>i(r)-i(s))}function EP(n,e,t,i,[s,r],o){let{quantity:a}=e,l=a.values?.[i]??null,c=`${n.nameOf(i)}${n.pointText(i)}: ${n.valueText(a,i)}`,h=Lt("g",{role:"option",tabindex:"-1","aria-label":c,"aria-selected":String(e.opened===i),"data-point":i,transform:`translate(${s.toFixed(1)} ${r.toFixed(1)})`},Lt("title",{},c)),{sign:u,pattern:d}=l===null?n.word(a.reasons[i]):{};return u&&h.setAttribute("class",`what ${d}`),n.shown(i)||h.classList.add("out"),e.front?.includes(i)&&h.append(Lt("circle",{r:o+3,class:"front"})),h.append(Lt("circle",{r:o,class:l===null?"missing":"found",fill:l===null?"transparent":t.colour(l).face})),u&&h.append(Lt("text",{"text-anchor":"middle",dy:"0.36em"},u)),e.best===i&&h.append(Lt("text",{class:"best","text-anchor":"middle",dy:-o-6},e.bestWord)),h}function TP(n,e,t){let[i,s]=[Uy(n.across.map(e.at)),Uy(n.upwards.map(t.at))];return n.works.flatMap((r,o)=>r.map((a,l)=>Lt("rect",{class:a?"map-works":"map-fails",x:i[o],width:i[o+1]-i[o],y:s[l+1],height:s[l]-s[l+1]})))}function Dp({boundaries:n},{x:e,y:t}){return!!n&&[e,t].every(i=>[n.x,n.y].includes(i))}function CP({cells:n,lines:e,x:t,y:i},s,r,o){let a=(u,d)=>i===null?[r.at(u),o.from+d*(o.to-o.from)]:s.x===t?[r.at(u),o.at(d)]:[r.at(d),o.at(u)],l=(u,d)=>`M${u.map(([f,p])=>`${f.toFixed(1)} ${p.toFixed(1)}`).join("L")}${d}`,c=n.map(([u,d,f,p])=>l([a(u,d),a(f,d),a(f,p),a(u,p)],"Z")),h=e.map(([u,d,f,p])=>l([a(u,d),a(f,p)],""));return[Lt("path",{class:"cell-outline",d:c.join("")}),Lt("path",{class:"boundary",d:h.join("")})]}function Uy(n){let e=n.slice(1).map((s,r)=>(s+n[r])/2),[t,i]=[n[0],n.at(-1)];return[t,...e,i]}function Fy(n,e,t,i){let s=(a,l)=>Lt("path",{class:l,d:i?`M${a} ${t.from}V${t.to}`:`M${t.from} ${a}H${t.to}`}),r=a=>a>=Math.min(e.from,e.to)&&a<=Math.max(e.from,e.to),o=[];typeof n.own=="number"&&r(e.at(n.own))&&o.push(s(e.at(n.own),"own"));for(let{kind:a,bound:l}of n.limits??[]){let c=e.at(l);if(!r(c))continue;let h=a===">="?e.from:e.to,[u,d]=[Math.min(c,h),Math.abs(c-h)],f=i?{x:u,width:d,y:t.to,height:t.from-t.to}:{y:u,height:d,x:t.from,width:t.to-t.from};o.push(Lt("rect",{class:"beyond",...f}),s(c,"limit"))}return o}function RP(n,e,t){let i=n.map(r=>e[r]).sort((r,o)=>r[0]-o[0]),s=([r,o])=>t==="least"?`H${r.toFixed(1)}V${o.toFixed(1)}`:`V${o.toFixed(1)}H${r.toFixed(1)}`;return Lt("path",{class:"front",d:i.map((r,o)=>o?s(r):`M${r.join(" ")}`).join("")})}function PP(n,e,t,i){let s=r=>r.target.closest("[data-point]");n.addEventListener("click",r=>{s(r)&&i(Number(s(r).dataset.point))}),n.addEventListener("focusin",r=>{for(let o of e)o.setAttribute("tabindex",o===r.target?"0":"-1")}),n.addEventListener("keydown",r=>{let o=s(r);if(!o||r.ctrlKey||r.metaKey||r.altKey)return;let a=Number(o.dataset.point);if(r.key==="Enter"||r.key===" ")i(a);else if(r.key in Oy)e[t[t.indexOf(a)+Oy[r.key]]]?.focus();else return;r.preventDefault()})}function By(n,{plane:e,front:t,best:i,best_word:s,joined:r},o){let{quantities:a}=n.study,[l,c]=[e.x,e.y].map(n.indexOf),[h,u]=[l,c],d={quantity:a[0],x:l,y:c,current:i??0,opened:null,front:t,best:i,bestWord:s,ordered:!0},f=v("div",{className:"map-place"}),p=v("div",{className:"map-legend"}),x=()=>{let C=d.x===h&&d.y===u;d.cells=C?e.cells:void 0,d.joined=r&&new Set([d.x,d.y,h,u]).size===2;let D=Ah(n,d,m);f.replaceChildren(D.element),p.replaceChildren(...IP(n,d))},m=C=>{g(C),o(C)};function g(C){d.current=d.opened=C;let D=f.contains(document.activeElement);x(),D&&f.querySelector(`[data-point="${C}"]`)?.focus()}let _=n.columns.map((C,D)=>[D,C.name]),w={across:S("across",_,()=>d.x,C=>M("x","y",C)),upwards:S("upwards",_,()=>d.y,C=>M("y","x",C)),show:S("show",a.map((C,D)=>[D,C.title]),()=>a.indexOf(d.quantity),C=>{d.quantity=a[C]})};function S(C,D,U,N){let z=v("select",{},...D.map(([H,se])=>v("option",{value:String(H)},se)));z.value=String(U()),z.addEventListener("change",()=>{N(Number(z.value)),A(),x()});let W=v("label",{},`${C} `,z);return W.dataset.name=C,{element:W,fill:()=>{z.value=String(U())}}}let A=()=>Object.values(w).forEach(C=>C.fill());function M(C,D,U){d[D]===U&&(d[D]=d[C]),d[C]=U}let y=()=>[d.y,d.x].map(C=>n.columns[C].name).join(" over "),b=ji(e.title,()=>qn(y()),()=>cr([f,p],y())),T=v("div",{className:"head"},v("h2",{},e.title),b),P=v("section",{className:"map"},T,v("div",{className:"choices"},...Object.values(w).map(C=>C.element)),f,p);return n.whenAsked(x),x(),{element:P,show:g,over(C,D){[d.x,d.y]=[C,D],A(),x()}}}function IP(n,{quantity:e,front:t,cells:i,x:s,y:r}){let o=vh(n,e),a=e.values?e.reasons:n.study.verdicts,l=n.study.words.flatMap((h,u)=>{let d=a.filter((f,p)=>f===u&&n.shown(p)).length;return d?[v("li",{},Jo(h),`${h.word} (${d})`)]:[]});t.length&&l.push(v("li",{},v("span",{className:"ring","aria-hidden":"true"}),"Pareto front"));let c=[s,r].map(h=>n.columns[h]);if(c.some(h=>typeof h.own=="number")&&l.push(v("li",{},v("span",{className:"dashes","aria-hidden":"true"}),"as designed")),c.some(h=>h.limits.length)&&l.push(v("li",{},v("span",{className:"shade","aria-hidden":"true"}),"beyond a limit")),i)for(let h of["works","fails"])l.push(v("li",{},v("span",{className:`map-${h}`,"aria-hidden":"true"}),`${h} if only these two deviate`));return l.length&&o.push(v("ul",{},...l)),o}var LP=2e4,NP=16,DP=16,kP=12,zy={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function Hy(n,e){let{quantities:t,sampled:i}=n.study,s=n.study.axes.filter(_=>n.sizes[_]>1),[r,o]=s.length>1?s:OP(n.study.factors[s[0]])?[s[0],null]:[null,s[0]??0],a={quantity:t[0],x:o,y:r,fixed:[...n.study.cuts],current:null,opened:null},l=v("div",{className:"map-place"}),c=v("div",{className:"map-legend"}),h=v("p",{className:"note"}),u=()=>{let _=a.y===null&&a.quantity.values&&n.sizes.every((S,A)=>S===1||A===a.x),w=i||_?Ah(n,a,d):BP(n,a,d);l.replaceChildren(w.element),c.replaceChildren(...GP(n,a.quantity,w.points),...Dp(n.study,a)?[HP(n.study.boundaries)]:[]),h.textContent=WP(n,a.quantity,w.points)},d=_=>{a.current=a.opened=_,UP(l,_),e(_,a.quantity)},f=FP(n,a,s,u),x=ji("the map",()=>qn(a.quantity.title),()=>cr([l,c],$y(n,a).split(";")[0])),m=v("div",{className:"head"},v("h2",{},"Map"),x),g=v("section",{className:"map"},m,f.element,l,c,h);return u(),{element:g,show(_){a.current=a.opened=_,i||(a.fixed=n.placesOf(_)),f.fill(),u()}}}function OP(n){return n?.values.some(e=>typeof e=="string"&&e.length>kP)??!1}function UP(n,e){for(let t of n.querySelectorAll("[data-point]")){let i=Number(t.dataset.point)===e;t.setAttribute("aria-selected",String(i)),t.tabIndex=i?0:-1}}function FP(n,e,t,i){let{factors:s,quantities:r,sampled:o}=n.study,a=v("div",{className:"choices"}),l=(u,d,f,p)=>{let x=v("select",{},...d.map(([m,g])=>v("option",{value:String(m)},g)));return x.value=String(f),x.addEventListener("change",()=>{p(Number(x.value)),h(),i(),[...a.querySelectorAll("label")].find(m=>m.dataset.name===u)?.querySelector("select").focus()}),v("label",{},`${u} `,x)},c=(u,d)=>f=>{e[d]===f&&(e[d]=e[u]),e[u]=f};function h(){let u=[l("show",r.map((d,f)=>[f,d.title]),r.indexOf(e.quantity),d=>{e.quantity=r[d]})];if(t.length>2){let d=t.map(f=>[f,s[f].name]);u.push(l("across",d,e.x,c("x","y")),l("upwards",d,e.y,c("y","x")))}for(let d of t.filter(f=>!o&&f!==e.x&&f!==e.y)){let f=s[d].texts.map((p,x)=>[x,s[d].unit?`${p} ${s[d].unit}`:p]);u.push(l(s[d].name,f,e.fixed[d],p=>{e.fixed[d]=p}))}for(let d of u)d.dataset.name=d.firstChild.textContent.trim();a.replaceChildren(...u)}return h(),{element:a,fill:h}}function BP(n,e,t){let{factors:i}=n.study,[s,r]=[e.x,e.y].map(g=>g===null?1:n.sizes[g]),o=e.x===null;if(s*r>LP)return{element:v("p",{className:"note"},"This map has too many cells for a page; see the figures of the study."),points:[]};let a=n.scaleOf(e.quantity),l=s<=NP,c=(g,_)=>n.pointAt(e.fixed.map((w,S)=>S===e.x?g:S===e.y?_:w)),h=new Map,u=[],d=[];for(let g=0;g<r;g++){let _=o?g:r-1-g,w=e.y===null?"":o?i[e.y].texts[_]:Gy(i[e.y],_),S=v("tr",{},v("th",{scope:"row"},w));for(let A=0;A<s;A++){let M=c(A,_),y=v("td",{tabIndex:-1,role:"gridcell"});zP(y,n,e,a,M,l),h.set(`${A} ${_}`,y),d.push(M),S.append(y)}u.push(S)}if(!o){let g=i[e.x].texts.map((_,w)=>v("th",{scope:"col"},Gy(i[e.x],w)));u.push(v("tr",{className:"feet"},v("td"),...g))}let f=v("table",{role:"grid",className:o?"grid list":l?"grid":"grid small","aria-label":$y(n,e)},v("tbody",{},...u));f.style.setProperty("--columns",s),f.style.setProperty("--rows",r);let p=[...h.values()].find(g=>Number(g.dataset.point)===e.current)??h.get("0 0");p.tabIndex=0,VP(f,h,t,o);let x=v("div",{className:"upwards"},e.y===null||o?"":Vy(i[e.y])),m=v("div",{className:"across"},o?"":Vy(i[e.x]));return{element:v("div",{className:r<6?"axes low":"axes"},x,v("div",{},v("div",{className:"scroll"},f),m)),points:d}}function zP(n,e,t,i,s,r){let{quantity:o}=t,a=o.values?.[s]??null;n.dataset.point=s,n.setAttribute("aria-selected",String(t.opened===s));let l=`${e.pointText(s)}: ${o.values?`${o.title} `:""}${e.valueText(o,s)}`;if(n.setAttribute("aria-label",l),n.title=l,a===null){let{sign:u,pattern:d}=e.word(o.reasons[s]);n.className=`what ${d}`,n.append(v("span",{},r?u:""));return}let{face:c,ink:h}=i.colour(a);n.style.background=c,n.style.color=h,n.textContent=r?i.text(a):""}function VP(n,e,t,i){let s=new Map([...e].map(([r,o])=>[o,r.split(" ").map(Number)]));n.addEventListener("click",r=>{let o=r.target.closest("[data-point]");o&&t(Number(o.dataset.point))}),n.addEventListener("keydown",r=>{let o=r.target.closest("[data-point]");if(!o||r.ctrlKey||r.metaKey||r.altKey)return;let[a,l]=s.get(o),[c,h]=zy[r.key]??[0,0],u=i?-h:h,d=Math.max(...[...s.values()].map(([p])=>p)),f={Home:`0 ${l}`,End:`${d} ${l}`}[r.key]??`${a+c} ${l+u}`;if(r.key==="Enter"||r.key===" ")t(Number(o.dataset.point));else{if(!(r.key in zy)&&r.key!=="Home"&&r.key!=="End")return;e.has(f)&&(o.tabIndex=-1,e.get(f).tabIndex=0,e.get(f).focus())}r.preventDefault()})}function GP(n,e,t){let i=vh(n,e),s=[...Wy(e,t)].map(([r,o])=>{let a=n.word(r);return v("li",{},Jo(a),`${a.word} (${o})`)});return s.length&&i.push(v("ul",{},...s)),i}function HP({text:n}){let e=(t,i)=>v("li",{},v("span",{className:`line ${t}`,"aria-hidden":"true"}),i);return v("ul",{},e("boundary",`${n}, a straight line in each cell`),e("cell-outline","side of a cell"))}function Wy(n,e){let t=new Map;for(let i of e){let s=n.reasons[i];s!==null&&t.set(s,(t.get(s)??0)+1)}return new Map([...t].sort(([i],[s])=>i-s))}function WP(n,e,t){let i=t.filter(h=>(e.values?.[h]??null)!==null),s=[...Wy(e,t)].map(([h,u])=>`${u} ${n.word(h).word}`),r=`${e.title[0].toUpperCase()}${e.title.slice(1)}`,o=`${n.study.noun}s`;if(!i.length)return`${r} of ${t.length} ${o}: ${s.join(", ")||"none"}.`;let a=s.length?` Other ${o}: ${s.join(", ")}.`:"",[l,c]=[Math.min,Math.max].map(h=>$P(n,e,i,h));return`${r}, known for ${i.length} of ${t.length} ${o}: from ${l} to ${c}.${a}`}function $P(n,e,t,i){let s=t.map(a=>e.values[a]).reduce((a,l)=>i(a,l)),r=t.filter(a=>e.values[a]===s),o=r.length>1?`${r.length} ${n.study.noun}s`:n.pointText(r[0]);return`${n.valueText(e,r[0])} (${o})`}function $y(n,e){let{factors:t}=n.study,i=e.y===null||e.x===null?t[e.x??e.y].name:`${t[e.x].name} across and ${t[e.y].name} upwards`;return`${e.quantity.title} over ${i}; arrows move between cells, enter opens one`}function Vy(n){return n.unit?`${n.name} (${n.unit})`:n.name}function Gy(n,e){let t=Math.ceil(n.texts.length/DP);return e%t?"":n.texts[e]}var Xy=2,XP=20;function Zy(n){let e=document.getElementById("live")?.textContent??null,t=e&&JSON.parse(e),i=v("div",{className:"answer"}),s=v("p",{className:"outcome",role:"status"}),r=v("div"),o=v("div"),a=null,l=!1,c=0,h=Promise.resolve(),u=0;function d(_,w){if(u+=1,c=_,!t)return[];if(!Ru())return w?[]:[v("p",{className:"note"},`It cannot be simulated here either: ${t.refused}.`)];if(a)x(_);else if(!l){let S=v("button",{type:"button",className:"try"},w?"Try it and refine here":"Simulate it here"),A=v("p",{className:"note"});S.addEventListener("click",()=>f(S,A)),o.replaceChildren(v("div",{className:"offer"},S,A))}return[o]}async function f(_,w){l=_.disabled=!0,w.textContent="Starting the simulator …";try{a=await Vo(Kn(t.bench.clips[0]),t.bench,e,Uo),o.replaceChildren(i),i.replaceChildren(a.element),a.begin(),x(c)}catch(S){w.textContent=`It cannot be simulated here: ${S.message}.`}}async function p(_,w){if(await h.catch(()=>null),w!==u)return null;h=a.engine.ask({act:"answer",values:_,search:t.search});let{answer:S}=await h;return w===u?S:null}async function x(_){let w=++u,S=v("button",{type:"button"},"Refine here");S.addEventListener("click",()=>g(_)),r.replaceChildren(),i.replaceChildren(s,...jy(n,t).length?[S]:[],r,a.element),s.textContent="Simulating …",a.sliders.set(t.points[_]);let A=await p(t.points[_],w);A&&(s.textContent=`${Nt(n.pointText(_))}: ${Yy(t,A)}.`,m(_))}function m(_){a.sliders.set(t.points[_]),a.engine.send({act:"restart",through:!1})}async function g(_){let w=++u,S=YP(n,t,_),A=new Map,M=v("p",{className:"note",role:"status"}),y=S[1].values.map(D=>S[0].values.map(U=>qP(S,U,D))).reverse(),b=y.map((D,U)=>v("tr",{},v("th",{scope:"row"},qy(S[1],S[1].values.length-1-U)),...D.map(({cell:N})=>N))),T=v("tr",{className:"feet"},v("td"),...S[0].values.map((D,U)=>v("th",{scope:"col"},qy(S[0],U)))),P=v("table",{className:"grid"},v("caption",{},jP(S,n.study.sampled)),v("tbody",{},...b,T));r.replaceChildren(v("div",{className:"table",tabIndex:0,role:"group","aria-label":"finer map"},P),M);let C=y.flat();for(let[D,{cell:U,values:N,where:z}]of C.entries()){M.textContent=`${D} of ${C.length} points simulated`;let W=await p({...t.points[_],...N},w);if(!W)return;let{sign:H,pattern:se}=n.study.words.find(({word:Y})=>Y===W.word)??n.study.other;U.className=`what ${se}`,U.replaceChildren(v("span",{},H)),U.title=`${z}: ${Yy(t,W)}`,U.setAttribute("aria-label",U.title),A.set(W.word,H)}M.textContent=[...A].map(([D,U])=>`${U} ${D}`).join(" · "),m(_)}return{offer:d,get panel(){return a}}}function qP(n,e,t){let i={[n[0].key]:e};n[1].key&&(i[n[1].key]=t);let s=n.filter(({key:r})=>r).map(r=>`${r.name} ${Mt(r.factor*i[r.key])} ${r.unit}`).join(", ");return{cell:v("td",{"aria-label":`${s}: not simulated yet`}),values:i,where:s}}function jy(n,e){let t=i=>e.knobs.some(({key:s})=>s===n.study.factors[i].key);return n.study.axes.filter(i=>n.sizes[i]>1&&t(i))}function YP(n,e,t){let i=jy(n,e),[s,r]=i.length>1?i:[null,i[0]??0],o=a=>{if(a===null)return{key:"",name:"",unit:"",factor:1,values:[0]};let{key:l,name:c}=n.study.factors[a],h=e.knobs.find(m=>m.key===l);if(n.study.sampled)return{key:l,name:c,unit:h.unit,factor:h.factor,values:ZP(e.points.map(m=>m[l]),t)};let u=n.placesOf(t),d=m=>e.points[n.pointAt(u.map((g,_)=>_===a?m:g))][l],[f,p]=[Math.max(0,u[a]-1),Math.min(n.sizes[a]-1,u[a]+1)],x=[];for(let m=f;m<p;m++)for(let g=0;g<Xy;g++)x.push(d(m)+g/Xy*(d(m+1)-d(m)));return{key:l,name:c,unit:h.unit,factor:h.factor,values:[...x,d(p)]}};return[o(r),o(s)]}function ZP(n,e){let[t,i]=[Math.min(...n),Math.max(...n)],s=[-2,-1,0,1,2].map(r=>n[e]+r*(i-t)/XP);return[...new Set(s.map(r=>Math.min(i,Math.max(t,r))))].sort((r,o)=>r-o)}var qy=({key:n,factor:e,unit:t,values:i},s)=>n?`${Mt(e*i[s])} ${t}`:"";function jP([n,e],t){return`${e.key?`${Nt(n.name)} across, ${e.name} upwards`:Nt(n.name)}, ${t?"around it":"at half the steps"}`}function Yy(n,{status:e,least:t}){let s=(n.search?[n.search.first,n.search.second].filter(Boolean):[]).filter(({name:r})=>t[r]!==null&&t[r]!==void 0).map(({key:r,name:o,title:a})=>{let{factor:l,unit:c}=n.knobs.find(h=>h.key===r);return`${a} ${Mt(l*t[o])} ${c}`});return[e,...s].join("; ")}function Eh(n){let e=v("h2"),t=v("p",{className:"outcome",role:"status"}),i=v("table",{className:"numbers"}),s=v("section",{className:"facts",id:"point"},e,t,v("div",{className:"table"},i)),r=v("div",{className:"parts",role:"group","aria-label":`runs of this ${n.study.noun}`}),o=v("div"),a=v("div",{className:"more"}),l=v("section",{className:"run",id:"run","aria-label":"the run that is open"},r,o,a),c=v("section",{className:"run below","aria-label":"plots and numbers of the run that is open"}),h=Zy(n),u={facts:s,element:l,below:c,point:null,playing:null,answers:h,open:p,show:g},d=null,f=ar();function p(w,{play:S=!1,transition:A=null}={}){u.point=w;let M=n.runsOf(w);e.textContent=Nt(`${n.study.noun} ${w+1}`),t.textContent=`${Nt(n.pointText(w))}: ${n.study.statuses[w]}.`,i.replaceChildren(v("caption",{},n.study.numbers??"Values in the table"),v("tbody",{},...tI(n,w))),r.replaceChildren(...M.length>1?M.map(x):M.map(T=>v("b",{},Nt(T.title))));let y=A===null?null:M.find(T=>T.transition===A),b=S?M.find(T=>T.failed):null;M.length?g(y??b??M[0],{play:S}):(m(),o.replaceChildren(v("p",{className:"note"},nI(n,w))),c.replaceChildren()),a.replaceChildren(...n.study.built[w]?h.offer(w,M.length>0):[])}function x(w){let S=v("button",{type:"button"},w.title);return S.dataset.part=w.part,S.addEventListener("click",()=>g(w,{play:!0})),S}function m(){u.playing?.dispose(),u.playing=null}function g(w,{play:S=!1}={}){m();for(let C of r.querySelectorAll("button"))C.setAttribute("aria-pressed",String(C.dataset.part===w.part));let A=d&&d!==w?d:null,M=A?[A,w]:[w],y={player:v("div"),plots:v("div"),readouts:M.map(()=>v("div"))},[b,T]=[iI,sI].map(C=>M.map((D,U)=>C(D,Ky(M,n)[U]))),P=w.advice?[v("p",{className:"note"},w.advice)]:[];o.replaceChildren(v("p",{},w.text),_(w),...P,y.player),c.replaceChildren(y.plots,...y.readouts,...b,...T),f.scale=n.largestSpan/w.play.clips[0].span_m,u.playing={run:w,beside:A,...KP(y,w,A,n,f)},zo(c),S&&!matchMedia("(prefers-reduced-motion: reduce)").matches&&u.playing.clock.play()}function _(w){let A=v("button",{type:"button",className:"pin"},d?`unpin ${n.study.noun} ${d.point+1}`:"pin to compare with another");return A.addEventListener("click",()=>{d=d?null:w,g(w),o.querySelector(".pin").focus()}),A}return u}function KP(n,e,t,i,s){let r=t?[t,e]:[e],o=r.map((f,p)=>QP(f,Ky(r,i)[p],i)),a=r.map((f,p)=>({...Kn(f.play.clips[0]),...t?{name:o[p]}:{}})),l=Bi(a,t?[eI(a)]:e.play.spans),c=r.map(f=>f.play.energy).reduce((f,p)=>p.largest_J>f.largest_J?p:f),h=t?`${Nt(a[0].name)} and ${a[1].name}, side by side with a common clock.`:e.play.text,u=ur(n.player,a,l,{...e.play,energy:c,text:h},s);t&&Cp(u.stage.cells,a,l,c);let d=mr(n.plots,t?JP(r,a):e.play.plots,a,l);n.plots.classList.toggle("paired",t!==null);for(let[f,p]of a.entries())hr(n.readouts[f],p,l,c,f,t!==null);return{clips:a,clock:l,player:u,plots:d,dispose(){u.dispose(),d.dispose()}}}function JP(n,e){let t=n.map(({play:s},r)=>s.plots.map(o=>({...o,owner:e[r].name,sharing:`${o.title} ${o.unit}`,lines:o.lines.map(a=>({...a,clip:r}))})));return[...new Set(t.flat().map(s=>s.title))].flatMap(s=>t.flat().filter(r=>r.title===s))}function Ky(n,{study:e}){if(n.length===1)return[""];let t=new Set(n.map(i=>i.point)).size<n.length;return n.map(i=>`${e.noun} ${i.point+1}${t?`, ${i.title}`:""}`)}function QP(n,e,t){let{factors:i}=t.study,s=t.placesOf(n.point).map((r,o)=>`${i[o].texts[r]} ${i[o].unit}`.trim());return`${e}: ${s.join(", ")}`}function eI(n){let e=n.map(s=>s.stages.find(r=>r.driven)?.start??s.start),[t,i]=[Math.min(...n.map((s,r)=>s.start-e[r])),Math.max(...n.map((s,r)=>s.end-e[r]))];return{name:"whole runs",label:"time since the first drive acts",start:t,end:i,origins:e,whole:!0}}function tI(n,e){return n.numbers.map(t=>v("tr",{},v("th",{scope:"row"},t.title),v("td",{},n.valueText(t,e))))}function nI(n,e){return n.study.built[e]?`${n.study.unkept??"This run was not kept, so it cannot be played here."} ${n.study.keeps}`:n.study.unbuilt}function iI(n,e){let t=v("div");return t.innerHTML=n.numbers,v("details",{},v("summary",{},`States of ${e||"this run"}`),t)}function sI(n,e){let t=[`forficula run ${n.folder}/design.toml`,`forficula film ${n.folder} --out film.mp4`];return v("details",{},v("summary",{},e?`Commands for ${e}`:"Commands"),v("p",{className:"note"},"In the folder of this page, these commands repeat the run and make a film of it:"),v("pre",{},v("code",{},t.join(`
`))))}function Th(n,e,t,i){let s=n?.querySelector("table");if(!s)return()=>{};let r=[...s.tBodies[0].rows],o=v("p",{className:"note",role:"status"}),a=rI(e,()=>{let h=a.shown(),u=0;for(let[d,f]of r.entries())f.hidden=!h.has(e.study.verdicts[d])||!e.shown(d),u+=f.hidden?0:1;o.textContent=`${u} of ${r.length} ${e.study.noun}s shown.`});for(let[h,u]of r.entries()){let d=v("button",{type:"button","aria-label":`open ${e.study.noun} ${h+1}`},u.cells[0].textContent);d.addEventListener("click",()=>i(h)),u.cells[0].replaceChildren(d)}let l=e.study.factors.length+1;for(let h of[s.tHead.rows[0],...r])h.cells[l].classList.add("words");aI(s,r,oI(e));let c=v("div",{className:"choices"},a.element,...t?[cI(t,e.study.file)]:[]);return s.closest(".table").before(c,o),a.changed(),a.changed}function rI(n,e){let t=new Map,i=n.study.words.flatMap((r,o)=>{if(!r.count)return[];let a=v("input",{type:"checkbox",checked:!0});return a.addEventListener("change",e),t.set(o,a),[v("label",{},a,Jo(r),`${r.word} (${r.count})`)]});return{element:v("fieldset",{className:"filter"},v("legend",{},`Show ${n.study.noun}s that`),...i),changed:e,shown:()=>new Set([...t].filter(([,r])=>r.checked).map(([r])=>r))}}function oI(n){let{study:e}=n,t=e.statuses.map((r,o)=>o),i=e.factors.map((r,o)=>t.map(a=>r.values[n.placesOf(a)[o]])),s=n.numbers.map(r=>r.values);return[t,...i,e.statuses,...s]}function aI(n,e,t){let i=[...n.tHead.rows[0].cells];for(let[s,r]of i.entries()){let o=v("button",{type:"button"},...r.childNodes);r.replaceChildren(o),o.addEventListener("click",()=>{let a=r.getAttribute("aria-sort")==="ascending";for(let c of i)c.removeAttribute("aria-sort");r.setAttribute("aria-sort",a?"descending":"ascending");let l=e.map((c,h)=>h).sort((c,h)=>lI(t[s][c],t[s][h],a?-1:1)||c-h);n.tBodies[0].append(...l.map(c=>e[c]))})}i[0].setAttribute("aria-sort","ascending")}function lI(n,e,t){if(n===null||e===null)return(n===null)-(e===null);let i=typeof n=="number"?n-e:String(n).localeCompare(String(e),"en");return t*i}function cI(n,e){let t=v("button",{type:"button",className:"button"},`Download ${e}`);return t.addEventListener("click",()=>{let i=URL.createObjectURL(new Blob([n],{type:"text/csv;charset=utf-8"}));v("a",{href:i,download:e}).click(),setTimeout(()=>URL.revokeObjectURL(i),1e4)}),t}function Jy(n){let e=bh(n.study,n.runs),t=Eh(e),i=(a,l=null)=>{t.open(a,{play:!0,transition:l}),kp(t)},s=Hy(e,(a,l)=>i(a,l.transition)),r=n.runs.length?[[s.element,t.facts],[t.element]]:[[s.element],[t.facts,t.element]];document.getElementById("explorer").replaceChildren(v("div",{className:"explorer"},...r.map(a=>v("div",{},...a)),t.below)),Th(document.getElementById("points"),e,n.csv,a=>{s.show(a),i(a)});let o=uI(e,n.runs);return t.open(o),s.show(o),{model:e,map:s,panel:t,open:i}}function uI(n,e){let t=n.study.quantities.filter(o=>o.group==="torque"),i=o=>[n.study.verdicts[o],...t.map(a=>a.values[o]??1/0),o],s=(o,a)=>{let l=o.findIndex((c,h)=>c!==a[h]);return l>=0&&o[l]<a[l]};return e.map(o=>o.point).reduce((o,a)=>o===null||s(i(a),i(o))?a:o,null)??0}function kp({facts:n,element:e}){let{top:t}=e.getBoundingClientRect();if(t>=0&&t<.5*innerHeight)return;let i=n.getBoundingClientRect().left===e.getBoundingClientRect().left,s=matchMedia("(prefers-reduced-motion: reduce)").matches;(i?n:e).scrollIntoView({behavior:s?"auto":"smooth",block:"start"})}function Qy(n){let{views:e}=n,t=Ry(n.study,n.runs),i=Eh(t),s=[],r=(m,g)=>{i.open(m,{play:g});for(let _ of s)_.show?.(m)},o=m=>{r(m,!0),kp(i)},a=Ey(t,e.lines,e,o),l=t.columns.filter(m=>m.aim).length===2,c=By(t,{...e,joined:l},o),h=e.pairs?.length?Ly(t,e,u):null;s.push(a,c);function u(m,g){c.over(m,g),c.element.scrollIntoView({block:"start"})}let d=n.runs.length?[[c.element,i.facts],[i.element]]:[[c.element],[i.facts]],f=v("div",{className:"explorer"},...d.map(m=>v("div",{},...m)),i.below),p={lines:a.element,pairs:h?.element,plane:f};document.getElementById("explorer").replaceChildren(...e.order.map(m=>p[m]));let x=Th(document.getElementById("points"),t,n.csv,o);return t.whenAsked(x),n.study.points&&r(hI(t,n),!1),{model:t,panel:i,lines:a,plane:c,open:o}}function hI(n,{runs:e,views:t,study:i}){let{best:s}=t,r=e.map(o=>o.point);return s!==null&&r.includes(s)?s:r.find(o=>n.good(o))??r[0]??s??i.verdicts.findIndex((o,a)=>n.good(a)||a===i.points-1)}async function ev(n){let e=new Blob([Kt(n,Uint8Array)]).stream(),t=await new Response(e.pipeThrough(new DecompressionStream("deflate"))).arrayBuffer();function i({kind:s,start:r,shape:o,low:a,step:l}){let c=o.reduce((d,f)=>d*f,1);if(s==="f4")return new Float32Array(t,r,c);if(s==="f8")return new Float64Array(t,r,c);let h=new(s==="u2"?Uint16Array:Uint32Array)(t,r,c),u=dI(h,...o);return a?Float32Array.from(u,(d,f)=>a[f%o[1]]+l[f%o[1]]*d):u}return i}function dI(n,e,t){let i=n.constructor,s=new i(1),r=new i(n.length);for(let o=0;o<t;o++){s[0]=0;for(let a=0;a<e;a++)s[0]+=n[o*e+a],r[a*t+o]=s[0]}return r}var fI="M7 4.5v15l12-7.5z",pI="M7 5h3.5v14H7zM13.5 5H17v14h-3.5z",gr=180/Math.PI,Ch=1,tv=10,nv=720;function rv(n,e,t,i){let[s,r]=[n.lowest,n.highest].map(p=>p*gr),o=_I(n),a=xI(n,s,r,o),l=v("button",{type:"button",className:"play"}),c=v("input",{type:"range",min:s,max:r,step:"any","aria-label":"hinge angle"});c.dataset.keys="own";let h=v("p",{className:"time"}),u=p=>{e.pause(),e.seek(i(Math.min(r,Math.max(s,p))/gr))},d=()=>e.playing?e.pause():e.play(),f=a.map(({angle:p,name:x})=>{let m=v("button",{type:"button"},v("b",{},iv(p)),` ${x}`);return m.addEventListener("click",()=>u(p)),m});return c.addEventListener("input",()=>u(Number(c.value))),gI(c,()=>t(e.time)*gr,u,d),l.addEventListener("click",d),e.onChange(()=>{let p=t(e.time)*gr;c.value=p,h.textContent=`${iv(p,1)}${sv(n,p)}`,c.setAttribute("aria-valuetext",`${kn(p,1)} degrees${sv(n,p)}`);for(let[m,g]of a.entries())f[m].setAttribute("aria-pressed",String(Math.abs(g.angle-p)<.005));let x=e.playing?"pause":"play: fold from stop to stop";l.getAttribute("aria-label")!==x&&l.replaceChildren(Tl(e.playing?pI:fI)),l.setAttribute("aria-label",x)}),v("div",{className:"transport"},v("div",{className:"line"},l,mI(c,s,r,o,a)),v("div",{className:"choices"},h,v("div",{className:"states"},...f)))}function mI(n,e,t,i,s){let r=v("div",{className:"bands","aria-hidden":"true"}),o=v("div",{className:"ticks","aria-hidden":"true"}),a=l=>`${100*l/(t-e)}%`;for(let[l,c]of i){let h=v("span",{className:"band"});Object.assign(h.style,{left:a(l-e),width:a(c-l)}),r.append(h)}for(let{angle:l,stop:c}of s){let h=v("span",{className:c?"tick stop":"tick"});h.style.left=a(l-e),o.append(h)}return v("div",{className:"track"},r,n,o)}function gI(n,e,t,i){let s={ArrowLeft:-Ch,ArrowDown:-Ch,ArrowRight:Ch,ArrowUp:Ch},r={PageDown:-tv,PageUp:tv,Home:-1/0,End:1/0};n.addEventListener("keydown",o=>{if(!(o.shiftKey||o.ctrlKey||o.metaKey||o.altKey)){if(o.key===" ")i();else if(o.key in s)t(Math.round(e()+s[o.key]));else if(o.key in r)t(e()+r[o.key]);else return;o.preventDefault()}})}var iv=(n,e=null)=>`${e===null?kn(n,Number.isInteger(Number(n.toFixed(3)))?0:1):kn(n,e)}°`;function xI(n,e,t,i){if(n.folds){let a=[{angle:e,name:"flat",stop:!0},{angle:t,name:"folded",stop:!0}];return t>e?a:a.slice(0,1)}let s=a=>[...new Set(n.joints.map(l=>Number((l[a]*gr).toFixed(6))))],r=[...s("lower").map(a=>({angle:a,name:"folding stop",stop:!0})),...i.flatMap(([a,l])=>[a,l].map(c=>({angle:c,name:"all straps slack"}))),...e<0&&t>0?[{angle:0,name:"flat"}]:[],...s("upper").map(a=>({angle:a,name:t>0?"overbend stop":"stop, flat",stop:!0}))],o=a=>Math.abs(a-e)<1e-6||Math.abs(a-t)<1e-6;return r.filter(a=>a.stop||a.name==="flat"||!o(a.angle)).sort((a,l)=>a.angle-l.angle)}function _I(n){let e=a=>ov(n,a).every(({longer:l})=>l<0),[t,i]=[n.lowest*gr,n.highest*gr],s=(a,l)=>{let c=e(a);for(let h=0;h<40;h++){let u=(a+l)/2;e(u)===c?a=u:l=u}return l},r=[];if(!n.straps.length)return r;let o=e(t)?null:t;for(let a=1;a<=nv;a++){let[l,c]=[a-1,a].map(h=>t+(i-t)*h/nv);e(l)!==e(c)&&(o===null?o=s(l,c):(r.push([o,s(l,c)]),o=null))}return o!==null&&r.push([o,i]),r}function ov(n,e){let t=n.turn(n.anglesTogether(e/gr));return n.straps.flatMap(i=>n.strapStretches(i,t).map(s=>({longer:s,rest:i.rest})))}function sv(n,e){let t=ov(n,e);if(!t.length)return"";let i=t.filter(({longer:a})=>a<0).length,s=Math.max(...t.map(({longer:a})=>a));if(i===t.length)return`, straps slack by ${kn(-1e3*s,1)} mm or more`;let r=Math.max(...t.map(({longer:a,rest:l})=>a/l)),o=`stretched by up to ${kn(1e3*s,1)} mm (${kn(100*r,1)} %)`;return i?`, ${i} of ${t.length} straps slack, others ${o}`:`, straps ${o}`}function av(n){let e=v("input",{type:"range",min:0,max:100,step:1,value:0});return e.dataset.keys="own",e.addEventListener("input",()=>n(Number(e.value)/100)),e.setAttribute("aria-valuetext","together"),e.addEventListener("input",()=>{e.setAttribute("aria-valuetext",e.value==="0"?"together":`${e.value} % apart`)}),v("label",{className:"slide"},"take apart ",e)}function lv(n,e,t){let i=n.map((s,r)=>{let o=v("input",{type:"checkbox",checked:!0});o.dataset.keys="own",o.addEventListener("change",()=>t(r,o.checked));let a=v("span",{className:"swatch panel","aria-hidden":"true"});return a.style.background=s.colour,v("label",{},o,a,`${s.name}${e[r]>1?`, ${e[r]}`:""}`)});return v("fieldset",{className:"kinds"},v("legend",{},"show"),...i)}function Op(n,e,t){let i=v("select",{},...e.map((s,r)=>v("option",{value:String(r)},s)));return i.addEventListener("change",()=>t(Number(i.value))),v("label",{},`${n} `,i)}var Rh=28,cv=24;function uv(n,e){return n.ends.map(t=>{let[i,s]=t.map((r,o)=>new G(...r).applyMatrix4(ea(e,n.bodies[o])));return i.distanceTo(s)-n.rest})}var yI=new dt,ea=(n,e)=>e<0?yI:n[e];function Up(n,e,t,i,s){let r=new G(...n.axis).transformDirection(ea(e,n.bodies[0])),o=new G(...n.up).transformDirection(ea(e,n.bodies[0]));return n.ends.map(a=>{let l=a.map((_,w)=>new G(..._).applyMatrix4(ea(e,n.bodies[w])).add(i)),c=l[1].clone().sub(l[0]),h=c.dot(r);c.addScaledVector(r,-h);let u=c.length(),d=u>1e-9?c.divideScalar(u):new G().crossVectors(r,o),f=new G().crossVectors(r,d).multiplyScalar(t),x=n.rest>Math.hypot(u,h)?Math.sqrt(n.rest**2-h**2):u,m=vI(s,x>1e-9?u/x:1);return{points:m.map(([_,w],S)=>l[0].clone().addScaledVector(d,_*x).addScaledVector(f,w*x).addScaledVector(r,h*S/(m.length-1))),wide:r,ends:l}})}function vI({values:n,shape:e},t){let[i,s]=e,r=Math.sqrt(Math.max(0,1-t))*(i-1),o=Math.min(i-2,Math.floor(r)),a=Math.min(1,r-o),l=(d,f,p)=>n[(d*s+f)*2+p],c=(d,f)=>l(o,d,f)+a*(l(o+1,d,f)-l(o,d,f)),h=c(s-1,0),u=h>1e-6?t/h:1;return Array.from({length:s},(d,f)=>[u*c(f,0),c(f,1)])}function hv(n,e,t){let i={triangles:[],edges:[]};for(let{points:s,wide:r,ends:o}of e){let a=r.clone().multiplyScalar(n.width/2),l=s.map((c,h)=>{let d=s[Math.min(h+1,s.length-1)].clone().sub(s[Math.max(h-1,0)]).cross(r).setLength(n.thickness/2);return[[-1,-1],[1,-1],[1,1],[-1,1]].map(([f,p])=>c.clone().addScaledVector(a,f).addScaledVector(d,p))});fv(i,l,[0,1,2,3]);for(let[c,h]of o.entries()){let u=new G(...n.across[c]).transformDirection(ea(t,n.bodies[c]));SI(i,h,u,n.width,n.eye/2,n.peg/2)}}return i}function Fp(n,e,t){let i=n.places.map(x=>new G(...x).add(t)),[s,r,o,a]=i,l=ea(e,n.body),[c,h]=[o,a].map(x=>x.clone().sub(t).applyMatrix4(l).add(t)),u=r.clone().sub(s).normalize(),d=h.clone().sub(c).normalize(),f=r.distanceTo(o),p=[s];for(let x=0;x<=cv;x++)p.push(bI(r,u,c,d,f,x/cv));return[...p,h]}function bI(n,e,t,i,s,r){let[o,a]=[1-r,r];return n.clone().multiplyScalar(o*o*(1+2*a)).addScaledVector(t,a*a*(1+2*o)).addScaledVector(e,s*o*o*a).addScaledVector(i,-s*a*a*o)}function dv(n,e){let t={triangles:[],edges:[]},i=n[1].clone().sub(n[0]).normalize(),s=new G(Math.abs(i.z)<.9?0:1,0,Math.abs(i.z)<.9?1:0),r=n.map((o,a)=>{let l=n[Math.min(a+1,n.length-1)].clone().sub(n[Math.max(a-1,0)]).normalize();s=s.clone().addScaledVector(l,-s.dot(l)).normalize();let c=new G().crossVectors(l,s);return Array.from({length:Rh},(h,u)=>{let d=2*Math.PI*u/Rh;return o.clone().addScaledVector(s,Math.cos(d)*e/2).addScaledVector(c,Math.sin(d)*e/2)})});return fv(t,r,[]),t}function fv({triangles:n,edges:e},t,i){let s=t[0].length;for(let r=1;r<t.length;r++){let[o,a]=[t[r-1],t[r]];for(let l=0;l<s;l++){let c=(l+1)%s;n.push(o[l],o[c],a[c],o[l],a[c],a[l]),i.includes(l)&&e.push(o[l],a[l])}}for(let r of[t[0],t.at(-1)])for(let o=1;o<s-1;o++)n.push(r[0],r[o],r[o+1])}function SI({triangles:n,edges:e},t,i,s,r,o){let a=new G(Math.abs(i.z)<.9?0:1,0,Math.abs(i.z)<.9?1:0);a.addScaledVector(i,-a.dot(i)).normalize();let l=new G().crossVectors(i,a),c=(h,u,d)=>t.clone().addScaledVector(i,d*s/2).addScaledVector(a,u*Math.cos(h)).addScaledVector(l,u*Math.sin(h));for(let h=0;h<Rh;h++){let[u,d]=[h,h+1].map(p=>2*Math.PI*p/Rh),f=(p,x,m,g)=>n.push(p,x,m,p,m,g);f(c(u,r,-1),c(d,r,-1),c(d,r,1),c(u,r,1));for(let p of[-1,1])f(c(u,o,p),c(d,o,p),c(d,r,p),c(u,r,p)),e.push(c(u,r,p),c(d,r,p))}}function pv(n,e){let t=e.map(({origin:a,axis:l})=>[new G(...a),new G(...l)]),i=n.map((a,l)=>e.flatMap((c,h)=>c.body===l?[h]:[])),s=n.map(()=>new dt),r=new dt,o=new G;return function(l){for(let[c,h]of n.entries()){let u=s[c];h<0?u.identity():u.copy(s[h]);for(let d of i[c]){let[f,p]=t[d];r.makeRotationAxis(p,l[d]-e[d].built),o.copy(f).applyMatrix4(r),r.setPosition(f.x-o.x,f.y-o.y,f.z-o.z),u.multiply(r)}}return s}}var wI=[-1,0,1].flatMap(n=>[-1,0,1].flatMap(e=>[-1,0,1].map(t=>[n,e,t]))),MI=new dt;function mv(n,e){let t=n.parts.map(x=>({...x,...x.mesh?AI(x.mesh,e):{}})),i={values:e(n.bows),shape:n.bows.shape},s=pv(n.bodies,n.turns),r=Math.min(...n.joints.map(x=>x.lower)),o=Math.max(...n.joints.map(x=>x.upper)),a=new Float64Array(n.turns.length),l=n.fold&&e(n.fold);function c(x){if(l)return h(x);for(let[m,g]of n.turns.entries())a[m]=g.built;for(let m of n.joints)a[m.turn]=Math.min(m.upper,Math.max(m.lower,x));return a}function h(x){let[m,g]=n.fold.shape,_=o>0?x/o*(m-1):0,w=Math.min(Math.floor(_),Math.max(m-2,0)),S=Math.min(w+1,m-1);for(let A=0;A<g;A++){let M=l[w*g+A];a[A]=M+(_-w)*(l[S*g+A]-M)}return a}let u=(x,m)=>new G(...x.apart).multiplyScalar(m);function d(x,m,g,_=new dt){let w=u(x,g);return _.copy(x.body===null||x.body<0?MI:m[x.body]).multiply(new dt().makeTranslation(w.x,w.y,w.z))}function f(x,m,{apart:g,side:_}){let w=u(x,g);return x.root?dv(Fp(x.root,m,w),x.root.diameter):hv(x.strap,Up(x.strap,m,_,w,i),m)}function p(x,m,{apart:g,side:_}){let w=[];for(let S of x){if(S.outer){let y=d(S,m,g);for(let b of S.outer)w.push(...b.clone().applyMatrix4(y).toArray());continue}let A=u(S,g),M=S.root?[Fp(S.root,m,A)]:Up(S.strap,m,_,A,i).map(y=>y.points);for(let y of M)for(let b=0;b<y.length;b+=4)w.push(...y[b].toArray())}return Float64Array.from(w)}return{parts:t,looks:n.looks,joints:n.joints,folds:!!l,turns:n.turns,lowest:r,highest:o,turn:s,anglesTogether:c,matrixOf:d,bentMesh:f,outline:p,straps:t.filter(x=>x.strap).map(x=>x.strap),strapStretches:uv}}function AI({points:n,triangles:e,stops:t,edges:i},s){let r=s(n),o=s(e),a=n.shape[0];for(let l=0;l<o.length;l+=3)o[l+1]=(o[l]+o[l+1])%a,o[l+2]=(o[l]+o[l+2])%a;return{places:r,corners:o,stops:t,edges:s(i),outer:EI(r)}}function EI(n){let e=new Set;for(let[t,i,s]of wI){let[r,o]=[0,-1/0];for(let a=0;a<n.length;a+=3){let l=t*n[a]+i*n[a+1]+s*n[a+2];l>o&&([r,o]=[a,l])}e.add(r)}return Array.from(e,t=>new G().fromArray(n,t))}function gv(n,e){let t=e(n.time),i=e(n.angles),[,s]=n.angles.shape,r=new Float64Array(s);function o(a){let[l,c]=Dr(t,a),h=Math.min(l+1,t.length-1);for(let u=0;u<s;u++){let d=i[l*s+u];r[u]=d+c*(i[h*s+u]-d)}return r}return{time:t,anglesAt:o,marks:n.marks,stages:n.stages,spans:n.spans}}var TI="#14171a",CI=.55,RI=Math.cos(Math.PI/9),PI=.42;function xv(n,e,t,i){let s=n.parts.map(f=>II(f,n.looks[f.look].colour,i)),r=new Ln;for(let f of s)r.add(f.mesh,f.lines);let o=new Ln,a=n.turn(n.anglesTogether(0));function l(f){a=n.turn(t(f));for(let[p,x]of n.parts.entries()){let{mesh:m,lines:g}=s[p],_=!e.hidden.has(x.look);for(let w of[m,g])w.visible=_;_&&(x.places?n.matrixOf(x,a,e.apart,m.matrix):DI(s[p],n.bentMesh(x,a,e)))}}function c(){let f=new je(_t("--accent"));for(let[p,{mesh:x}]of s.entries())for(let m of[x.material].flat())m.emissive.copy(f),m.emissiveIntensity=e.chosen===p?PI:0}function h(f,p){let x=new Tr;x.setFromCamera(f,p),r.updateMatrixWorld(!0);for(let{mesh:g}of s)g.geometry.boundingSphere===null&&g.geometry.computeBoundingSphere();let[m]=x.intersectObjects(s.map(g=>g.mesh).filter(g=>g.visible),!1);return m?s.findIndex(g=>g.mesh===m.object):null}function u(f){let p=n.parts.findIndex(_=>_.name===f),{mesh:x}=s[p],m=x.geometry.getAttribute("position"),g=new un(m.array.slice(),3);return Array.from(g.applyMatrix4(x.matrix).array)}function d(){for(let{mesh:f,lines:p}of s){f.geometry.dispose(),p.geometry.dispose();for(let x of[f.material,p.material].flat())x.dispose()}}return{group:r,shadow:o,pose:l,paint:c,sort:()=>{},at:h,verticesOf:u,dispose:d,current:()=>a}}function II(n,e,t){let i=(h,u)=>new Ts({color:h,side:zn,flatShading:u,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),s=n.places?LI(n):new bn,r=n.places?[i(t,!1),i(e,!1)]:i(e,!0),o=new _n(s,r),a=new bn;n.places&&a.setAttribute("position",new un(_v(n.places,n.edges),3));let l=new js({color:TI,transparent:!0,opacity:CI}),c=new Ar(a,l);for(let h of[o,c])Object.assign(h,{frustumCulled:!1,matrixAutoUpdate:!1});return c.matrix=o.matrix,{mesh:o,lines:c}}function LI({places:n,corners:e,stops:t}){let i=new bn;return i.setAttribute("position",new un(_v(n,e),3)),i.setAttribute("normal",new un(NI(n,e),3)),i.addGroup(0,3*t,0),i.addGroup(3*t,e.length-3*t,1),i}function _v(n,e){let t=new Float32Array(3*e.length);for(let[i,s]of e.entries())for(let r=0;r<3;r++)t[3*i+r]=n[3*s+r];return t}function NI(n,e){let t=e.length/3,i=new Float64Array(e.length),s=Array.from({length:n.length/3},()=>[]);for(let l=0;l<t;l++){let[c,h,u]=[0,1,2].map(f=>3*e[3*l+f]),d=(f,p,x)=>n[p+x%3]-n[f+x%3];for(let f=0;f<3;f++)i[3*l+f]=d(c,h,f+1)*d(c,u,f+2)-d(c,h,f+2)*d(c,u,f+1);for(let f=0;f<3;f++)s[e[3*l+f]].push(l)}let r=Float64Array.from({length:t},(l,c)=>Math.hypot(...i.subarray(3*c,3*c+3))),o=new Float32Array(3*e.length),a=(l,c)=>i[3*l]*i[3*c]+i[3*l+1]*i[3*c+1]+i[3*l+2]*i[3*c+2];for(let l=0;l<e.length;l++){let c=Math.floor(l/3),h=[0,0,0];for(let d of s[e[l]])if(d===c||a(c,d)>=RI*r[c]*r[d])for(let f=0;f<3;f++)h[f]+=i[3*d+f];let u=Math.hypot(...h)||1;for(let d=0;d<3;d++)o[3*l+d]=h[d]/u}return o}function DI({mesh:n,lines:e},{triangles:t,edges:i}){for(let[s,r]of[[n,t],[e,i]]){let{geometry:o}=s,a=o.getAttribute("position");a?.count!==r.length&&(a=new un(new Float32Array(3*r.length),3),o.setAttribute("position",a));for(let[l,c]of r.entries())c.toArray(a.array,3*l);a.needsUpdate=!0,o.boundingSphere=null}}var kI=.25,yv=60,OI=4;async function vv(n){let e=await ev(n.arrays),t=mv(n,e),i={apart:0,side:1,hidden:new Set,chosen:null},s=[UI(t,i),...n.motion?[FI(t,i,gv(n.motion,e))]:[]],r=BI(s),o=document.getElementById("player"),a=VI(o,n,t,i,r),l=qI(t,n,i,a);return a.onPress(l.choose),{model:t,state:i,clock:s[0].clock,run:s[1]?.clock??null,...a,choose:l.choose}}function UI(n,e){let[t,i]=n.folds?[n.lowest,n.highest]:[n.highest,n.lowest],s=u=>t+u*(i-t),r=u=>(u-t)/(i-t||1),o=Float64Array.from({length:yv+1},(u,d)=>d/yv),a=u=>n.anglesTogether(s(u)),l=bv(n,e,{time:o,anglesAt:a,marks:[],stages:[]}),c=Bi([Sv(n,l,a)],[{name:"",label:"",start:0,end:1,origins:[0],whole:!1}]);c.setSpeed(kI);let h=rv(n,c,s,r);return{name:n.folds?"along the fold path":"all joints together",clip:l,clock:c,anglesAt:a,control:h}}function FI(n,e,t){let i=bv(n,e,t),s=Bi([Sv(n,i,t.anglesAt)],t.spans);return{name:"as in the simulated run",clip:i,clock:s,anglesAt:t.anglesAt,control:Vu([i],s)}}function bv(n,e,{time:t,anglesAt:i,marks:s,stages:r}){let o=()=>{let a=n.parts.filter(l=>!e.hidden.has(l.look));return a.length?a:n.parts};return{name:"",time:t,start:t[0],end:t[t.length-1],marks:s,stages:r,readings:[],along:[],reach:0,mesh:{tubes:[],joints:[],jointRadius:0},pointsAt:a=>n.outline(o(),n.turn(i(a)),e),stageAt:a=>r.findLast(l=>l.start<=a)??r[0],markAt:a=>s.find(l=>Math.abs(l.time-a)<1e-9)}}function Sv(n,e,t){let i=n.parts.filter(s=>s.outer).map(s=>({...s,outer:[s.outer[0],s.outer.at(-1)]}));return{...e,pointsAt:s=>n.outline(i,n.turn(t(s)),{apart:0,side:1})}}function BI(n){let e=n[0],t={of:null},i=new Set;for(let a of n)a.clock.onChange(()=>{if(a===e)for(let l of i)l()});let s=()=>e.clock.redraw(),r={get time(){return e.clock.time},get playing(){return e.clock.playing},get span(){return t.of!==e.clock.span&&(t={...e.clock.span,of:e.clock.span}),t},clipTime:(a,l)=>e.clock.clipTime(a,l),timeAt:a=>e.clock.timeAt(a),wayAt:a=>e.clock.wayAt(a),onChange(a){return i.add(a),s(),()=>i.delete(a)},seek:a=>e.clock.seek(a),seekClip:(a,l)=>e.clock.seekClip(a,l),step:a=>e.clock.step(a),play:()=>e.clock.play(),pause:()=>e.clock.pause()};return{clip:{...n[0].clip,pointsAt:a=>e.clip.pointsAt(a)},clock:r,sources:n,get now(){return e},anglesAt:a=>e.anglesAt(a),take(a){e.clock.pause(),e=n[a],t={of:null},s()},changed(){t={of:null},s()}}}var wv="Press a part, or its name in the table, for details.",zI="parts";function VI(n,e,t,i,s){let{clip:r,clock:o,sources:a}=s,l=null,h=ol([r],o,()=>l=xv(t,i,s.anglesAt,e.stopColour),e.text),u=Hu(h.eye,null);u.prepend(Bu(h,o,()=>({text:"",longest:0}),()=>[]));let d=v("div",{className:"picture"},h.element,...h.note?[h.note]:[],u),f=v("p",{className:"chosen",role:"status"},wv),p=v("div",{},a[0].control);return n.replaceChildren(d,f,p,GI(t,i,s,p),HI(t,i,s),WI(e,t,h),Lu([r],zI)),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label","the moving parts"),Nu(n,[r],o,h.eye,kr[0]),{stage:h,shape:l,info:f,repaint:()=>{l.paint(),o.seek(o.time)},onPress:x=>XI(h.canvas,m=>x(l.at(m,h.eye.camera)))}}function GI(n,e,t,i){let s=l=>{Object.assign(e,l),t.changed()},r=t.sources.map(l=>l.name),o=Op("motion",r,l=>{t.take(l),i.replaceChildren(t.now.control)}),a=Op("slack straps bow",["away from the hinge","towards the hinge"],l=>s({side:l?-1:1}));return v("div",{className:"choices"},...r.length>1?[o]:[],av(l=>s({apart:l})),...n.straps.length?[a]:[])}function HI(n,e,t){let i=n.looks.map((s,r)=>n.parts.reduce((o,a)=>o+(a.look===r?a.count:0),0));return lv(n.looks,i,(s,r)=>{r?e.hidden.delete(s):e.hidden.add(s),t.changed()})}function WI(n,e,t){let i=v("span",{className:"swatch taut","aria-hidden":"true"});return v("ul",{className:"legend"},...e.parts.some(s=>s.stops)?[$I(n.stopColour,"face of a stop")]:[],...e.straps.length?[v("li",{},i,"on the slider: range of taut straps")]:[],v("li",{},`squares of the grid: ${Mt(1e3*il(t.eye.size))} mm`))}function $I(n,e){let t=v("span",{className:"swatch panel","aria-hidden":"true"});return t.style.background=n,v("li",{},t,e)}function XI(n,e){let t=null;n.addEventListener("pointerdown",i=>{t=i.isPrimary?[i.clientX,i.clientY]:null}),n.addEventListener("pointerup",i=>{if(t===null||Math.hypot(i.clientX-t[0],i.clientY-t[1])>OI)return;let s=n.getBoundingClientRect(),[r,o]=[(i.clientX-s.left)/s.width,(i.clientY-s.top)/s.height];e(new Je(2*r-1,1-2*o))})}function qI(n,e,t,i){let r=Array.from(document.querySelectorAll("#bill tbody tr")).map((l,c)=>{let[h]=l.querySelector("th").childNodes,u=v("button",{type:"button",className:"name","aria-pressed":"false"},h.textContent);return h.replaceWith(u),u.addEventListener("click",()=>o(t.chosen===c?null:c)),u});function o(l){t.chosen=l;for(let[c,h]of r.entries())h.setAttribute("aria-pressed",String(c===l));i.info.textContent=l===null?wv:a(l),i.repaint()}function a(l){let c=n.parts[l],[h,u,d]=c.facts,f=c.count>1?`${c.count} identical ones, each `:"";return`${c.name}: ${n.looks[c.look].name} of ${h}, ${f}${u}, ${d}`}return{choose:o}}var YI=[.1,.2,.5,1,2,5,10,15,30,45,60,90,180],ZI=1.35;function Bp(n,e,t=[],i=null){let s=e.map(r=>jI(r,t[0],i));n.replaceChildren(...s.map(r=>r.element)),n.classList.add("plots");for(let r of s)r.start();return s}function jI(n,e,t){let[i,s,r]=[n.lines,n.balls,n.marks].map(y=>y.map(KI)),{element:o,head:a,key:l,place:c}=Sp(n),h=(s.length?s:[i[0]]).map(y=>v("span",{className:"ball"},s.length&&y.name.length<3?y.name:"")),u=s.map(y=>[y.places[0],y.values[0]]),d=Math.round(ZI*xh),f=JI(i),p=f,x=null,m=[];function g(){let y=i.map((T,P)=>v("li",{},vr(Fi(P)),T.name)),b=s.length?`the ${n.along} now`:"moved by the slider";l.replaceChildren(...y,v("li",{},v("span",{className:"ball still"}),b))}function _(){for(let[y,[b,T]]of u.entries()){let[P,C]=[x.valToPos(b,"x"),x.valToPos(T,"y")];h[y].style.transform=`translate(${P.toFixed(2)}px, ${C.toFixed(2)}px)`}}function w(){let y=t.clipTime(0);for(let[b,{places:T,values:P}]of s.entries())u[b]=[T,P].map(C=>or(e.time,C,y));_()}function S(y){p=y,x.setScale("x",{min:y[0],max:y[1]})}function A(y,b,T){if(p!==f){let{places:D,values:U}=i[0],N=U.filter((H,se)=>D[se]>=p[0]&&D[se]<=p[1]),[z,W]=[Math.min(...N),Math.max(...N)];return[z-.25*(W-z),W+.25*(W-z)]}let P=s.reduce((D,U)=>Math.max(D,U.most),T),C=Math.min(0,b);return[C-.06*(P-C||1),P+.1*(P-C||1)]}function M(){let y=hn.join(i.map(P=>[P.sorted.places,P.sorted.values]));x=new hn(QI({data:n,lines:i,balls:s,marks:r,energyRange:A},c.clientWidth,d),y,c),x.over.append(...h);let b=new ResizeObserver(()=>x.setSize({width:c.clientWidth,height:d}));b.observe(c),x.hooks.setSize=[_],x.hooks.setScale=[_],g();let T=sr(()=>{g(),x.redraw(!1)});a.append(wp(n,()=>x,{under:()=>[],over:()=>[...Mv(x,n.along==="run"?s:[]),...Av(x,r)]})),m=[T,()=>b.disconnect(),()=>x.destroy()],n.top&&c.after(e3(f,n.top,S)),s.length?(t.onChange(w),t3(x,s,e,t)):n3(n,i[0],c,(P,C)=>{u[0]=[P,C],_()}),S(f)}return{element:o,start:M,dispose:()=>m.forEach(y=>y()),now:u,get chart(){return x}}}function KI({name:n,places:e,values:t}){let i={name:n,places:Kt(e,Float32Array),values:Kt(t,Float32Array)},s=Array.from(i.places.keys()).sort((r,o)=>i.places[r]-i.places[o]);return i.most=i.values.reduce((r,o)=>Math.max(r,o),0),i.sorted={places:s.map(r=>i.places[r]),values:s.map(r=>i.values[r])},i}function JI(n){let e=n.flatMap(s=>[s.sorted.places[0],s.sorted.places.at(-1)]),[t,i]=[Math.min(...e),Math.max(...e)];return[t-.03*(i-t),i+.03*(i-t)]}function QI({data:n,lines:e,balls:t,marks:i,energyRange:s},r,o){let a=_h(),l=Ep(n);return{width:r,height:o,legend:{show:!1},cursor:{show:!1},pxAlign:0,padding:[10,12,0,0],scales:{x:{time:!1,auto:!1,dir:n.backwards?-1:1},y:{range:s}},series:[{},...Mp(e)],axes:[{...a,...Ap,labelFont:a.font,label:`${n.axis} (deg)`,values:l.values,incrs:YI,space:44},l],hooks:{draw:[c=>gh(c,[...Mv(c,n.along==="run"?t:[]),...Av(c,i)])]}}}function Mv(n,e){let[t,i]=[n.bbox.width/devicePixelRatio,n.bbox.height/devicePixelRatio];return e.flatMap(({places:r,values:o})=>Array.from(r,(a,l)=>[n.valToPos(a,"x"),n.valToPos(o[l],"y")])).filter(([r,o])=>r>0&&r<t&&o>0&&o<i).map(([r,o])=>({kind:"rect",x:r-.8,y:o-.8,width:1.6,height:1.6,fill:_t("--accent"),opacity:.55}))}function Av(n,e){let[t,i]=[n.bbox.width/devicePixelRatio,n.bbox.height/devicePixelRatio],s=e.flatMap(({name:r,places:o,values:a})=>{let l=Array.from(o,(f,p)=>[n.valToPos(f,"x"),n.valToPos(a[p],"y")]),[c,h]=l[l.length>>1],u=l.length===1?{kind:"circle",x:c,y:h,r:4.5,fill:_t("--page"),stroke:_t("--ink"),lineWidth:1.4}:{kind:"path",points:l,stroke:_t("--line-2"),lineWidth:7,opacity:.35},d=l.length>1?0:c>t/2?-1:1;return[u,{kind:"text",x:c+12*d,y:h-9,text:r,anchor:["end","middle","start"][d+1],fill:_t("--ink")}]});return[{kind:"clip",x:-6,y:0,width:t+12,height:i+6,shapes:s}]}function e3(n,e,t){let i=[["whole curve",n],["barrier enlarged",e]].map(([s,r],o)=>{let a=v("button",{type:"button","aria-pressed":String(o===0)},s);return a.addEventListener("click",()=>{for(let l of i)l.setAttribute("aria-pressed",String(l===a));t(r)}),a});return v("div",{className:"ranges",role:"group","aria-label":"part of the curve"},...i)}function t3(n,e,t,i){Tp(n,r=>{let o=n.over.getBoundingClientRect(),[a,l]=[r.clientX-o.left,r.clientY-o.top],[c,h]=[0,1/0];for(let{places:u,values:d}of e)for(let f=0;f<u.length;f++){let p=Math.hypot(n.valToPos(u[f],"x")-a,n.valToPos(d[f],"y")-l);p<h&&([c,h]=[f,p])}i.pause(),i.seekClip(0,t.time[c])})}function n3(n,e,t,i){let s=e.places.length-1,r=v("input",{type:"range",min:"0",max:String(s),value:"0"});r.setAttribute("aria-label",`${n.axis} along the curve`);let o=v("output",{"aria-live":"off"}),a=()=>{let l=Number(r.value);i(e.places[l],e.values[l]);let[c,h]=[Mt(e.places[l]),`${Mt(e.values[l])} ${n.unit}`];o.textContent=`${c}°, ${h}`,r.setAttribute("aria-valuetext",`${n.axis} ${c} degrees, energy ${h}`)};r.addEventListener("input",a),t.after(v("div",{className:"slide"},r,o)),a()}function Ph(n,e,t){let i=e.map(({name:l,title:c})=>{let h=v("button",{type:"button",title:`${l}: ${c}`},l);return h.addEventListener("click",()=>t(l)),h}),s=l=>{for(let c of i)c.setAttribute("aria-pressed",String(c.textContent===l))},r=e.map(({name:l,title:c})=>`${l}: ${c}`).join(" · "),o=`how the ${n} moves`;return{element:v("div",{className:"colours modes",role:"group","aria-label":o},v("span",{},...i),v("small",{},r)),mark:s}}function zp(n){let e=(n.paths??[]).map(c=>({...c,clips:c.clips.map(h=>({...n.clips?.[0],...h}))})),i=[...n.clips?[{...n,name:"motion",title:"in time, as simulated"}]:[],...e].map(i3),s={views:i};if(!i.length)return{...s,curves:Bp(document.getElementById("curves"),n.curves)};let r=document.getElementById("player"),o=null,a;s.choose=c=>{o?.leave(),o=c,a=c.show(a)??a,Object.assign(s,c),l.mark(c.name)};let l=Ph(n.whole,i,c=>s.choose(i.find(h=>h.name===c)));if(i.length>1&&r.before(l.element),s.choose(i[0]),n.clips){yh(r,s.clock);let c=i.find(u=>u!==i[0]),h=c&&(()=>{s.choose(c),r.scrollIntoView({block:"start"}),r.querySelector("input[type=range]").focus({preventScroll:!0})});s.trial=Yu(document.getElementById("try"),i[0].clips[0],n,()=>s.clock.pause(),h)}return s}function i3(n){let{name:e,title:t}=n,i=n.clips.map(Kn),s={name:e,title:t,clips:i,clock:null},r=[];return s.show=o=>{let a=h=>document.getElementById(h),l=Bi(i,n.spans);return s.clock&&l.seek(s.clock.time),s.clock=l,s.player=ur(a("player"),i,l,n,o,!1),s.curves=n.curves?Bp(a("curves"),n.curves,i,l):[],s.plots=mr(a("plots"),n.plots,i,l),n.notes&&a("player").append(...n.notes.map(h=>v("p",{className:"note"},h))),r=[hr(a("readout"),i[0],l,n.energy),()=>s.player.dispose(),()=>s.plots.dispose(),()=>s.curves.forEach(h=>h.dispose())],s.player.stage?.eye.look},s.leave=()=>r.forEach(o=>o()),s}var Tv={"Content-Type":"application/json"},Ev=19e6;async function Qn(n,e,t){let i=JSON.stringify(e);if(i.length>Ev)return{refused:`need files of at most ${Ev/1e6} MB in all`};try{return await(await fetch(n,{method:"POST",headers:Tv,body:i,signal:t})).json()}catch(s){if(s.name==="AbortError")throw s;return{refused:Vp}}}async function Ih(n,e,t,i){let s="",r={};try{let a=(await fetch(n,{method:"POST",headers:Tv,body:JSON.stringify(e),signal:t})).body.pipeThrough(new TextDecoderStream).getReader();for(let l=await a.read();!l.done;l=await a.read()){let c=`${s}${l.value}`.split(`
`);s=c.pop();for(let h of c)r=JSON.parse(h),i(r)}s&&(r=JSON.parse(s))}catch(o){if(o.name==="AbortError")throw o;return{refused:Vp}}return r.done||r.refused?r:{refused:Vp}}var Vp="the workbench does not answer; is forficula open still running?";var Gp=`forficula ${location.pathname}`;function Rv(n){let e={asked:null,base:null,reply:null,rejected:new Map};e.open=async(r,o,a=!0)=>{let l=r.files[0]?.name||r.design||"the design",c={...r,settings:o};n.says.wait(`Opening ${l}`);let h=n.picture(c,a),u=await Qn("design",{...r,settings:{}}),d=u.refused??await t(c,u,h);return d?(n.says.refuse(`${l} is not opened: ${d}`),n.resume()):e.rejected.clear(),e.reply&&s(e.reply),d};async function t(r,o,a=null){let l=performance.now(),c=new AbortController,h=()=>{Object.assign(e,{asked:r,base:o}),s(u)};n.says.wait("Building",()=>c.abort());let u=o;try{if(Object.keys(r.settings).length&&(u=await Qn("design",r,c.signal)),u.refused)return u.refused;let d=await s3(a??n.picture(r,!1),c.signal);if(d.refused)return d.refused;d.shown&&(h(),n.says.wait("Building"));let f=await Qn("model",r,d.shown?void 0:c.signal);if(f.refused&&!d.shown)return f.refused;d.shown||h(),await n.model(f.refused?{live:f,warnings:[]}:f),n.says.done(`Built in ${((performance.now()-l)/1e3).toFixed(1)} s.`)}catch(d){if(d.name!=="AbortError")throw d;return"building was stopped"}return""}e.change=async(r,o)=>{let{asked:a,rejected:l}=e,c=[...l].filter(([f])=>f!==r).map(([f,p])=>[f,p.text]),h=i(a.settings,[[r,o]]),u=c.length?[i(a.settings,[...c,[r,o]]),h]:[h],d="";for(let f of u)if(d=Cv(f,a.settings)?"":await t({...a,settings:f},e.base),!d){f===u[0]?l.clear():l.delete(r);break}d?(l.set(r,{text:o,why:d}),n.says.refuse(`${d} – the last working model is kept`),n.resume()):Cv(h,a.settings)&&n.says.done(""),s(e.reply)},e.slide=async r=>{let o=i(e.asked.settings,Object.entries(r)),a=await Qn("design",{...e.asked,settings:o});return a.refused?n.says.refuse(a.refused):(e.asked={...e.asked,settings:o},s(a))};function i(r,o){let a={...r};for(let[l,c]of o)c===""||c===e.base.keys.find(h=>h.key===l)?.value?delete a[l]:a[l]=c;return a}function s(r){e.reply=r,r3(e.asked),n.reply(e)}return e}function s3(n,e){let t=new Promise((i,s)=>e.addEventListener("abort",()=>s(e.reason)));return Promise.race([n,t])}var Cv=(n,e)=>JSON.stringify(Object.entries(n).sort())===JSON.stringify(Object.entries(e).sort());function Pv(){return JSON.parse(sessionStorage.getItem(Gp)??"null")}function r3(n){try{sessionStorage.setItem(Gp,JSON.stringify(n))}catch{sessionStorage.removeItem(Gp)}}function Iv(n){let e=v("textarea",{id:"file-text",className:"file",rows:24,spellcheck:!1,"aria-describedby":"file-note"}),t=v("button",{type:"button"},"Build this text"),s=v("div",{},v("label",{htmlFor:"file-text"},"The design file"),v("p",{className:"note",id:"file-note"},"Add or remove stages, tendons and whole sections here. The result counts as a new design file."),e,v("p",{className:"choices"},t));t.addEventListener("click",()=>n(e.value));let r="";return{element:s,show(o){o.text!==r&&(e.value=r=o.text)}}}function Lh(n,e){let t="";for(let i of new TextEncoder().encode(n))t+=String.fromCharCode(i);return`data:${e};base64,${btoa(t)}`}var Hp=40,o3=0;function Lv(n,e){let t=`key-${++o3}`,i=n.key.split(".").at(-1).replaceAll("_"," "),s=a3(n,t),r=v("button",{type:"button",className:"home",hidden:!0},"undo"),o=v("p",{className:"wrong",id:`${t}-wrong`}),a="",l=v("p",{className:"note",id:`${t}-notes`}),c=v("div",{className:"field"},v("label",{htmlFor:t,title:n.key},i),v("span",{className:"entry"},s,...l3(n,t),r),o,l);s.setAttribute("aria-describedby",`${t}-wrong ${t}-notes`),s.addEventListener("change",()=>{a=s.value.trim(),e(a)}),r.addEventListener("click",()=>{e(""),s.focus()}),r.setAttribute("aria-label",`undo the change of ${i}`);function h(d,f,p){(document.activeElement!==s||s.value.trim()===a)&&(s.value=f??d.value),a=s.value.trim(),u("");let x=f===void 0?null:p?.value||"left out";c.classList.toggle("changed",x!==null),r.hidden=x===null;let m=d.default&&d.default!=="needed"?`if left out ${d.default}`:"",_=[d.allowed,x===null?m:`was ${x}`,d.chosen&&`chosen: ${d.chosen}`].filter(Boolean).join(" · ").replaceAll(">=","≥").replaceAll("<=","≤");l.replaceChildren(Nt(d.meaning),v("span",{className:"may"},_))}function u(d,f){f!==void 0&&(s.value=a=f),o.textContent=d,c.classList.toggle("rejected",d!==""),d?(s.setAttribute("aria-invalid","true"),r.hidden=!1):s.removeAttribute("aria-invalid")}return{element:c,input:s,fact:n,show:h,reject:u}}function a3({key:n,value:e,words:t,onlyWords:i,default:s},r){if(i){let l=e?[]:[v("option",{value:""},s&&s!=="needed"?`left out: ${s}`:"left out")];return v("select",{id:r,"data-key":n},...l,...t.map(c=>v("option",{value:c},c)))}let o={id:r,spellcheck:!1,autocomplete:"off",autocapitalize:"off","data-key":n};if(e.length>Hp)return v("textarea",{...o,rows:Math.min(6,Math.ceil(e.length/Hp))});let a=v("input",{...o,type:"text"});return t.length&&a.setAttribute("list",`${r}-words`),a}function l3({words:n,onlyWords:e,value:t},i){return e||!n.length||t.length>Hp?[]:[v("datalist",{id:`${i}-words`},...n.map(s=>v("option",{value:s})))]}var c3=["pattern","tendon"];function Nv(n){let e=v("input",{type:"search",id:"find-key",spellcheck:!1,placeholder:"stiffness, length, torque …"}),t=v("p",{className:"note",role:"status"}),i=v("div",{className:"sections"}),s=v("section",{className:"keys-of-design","aria-label":"keys of the design"},v("h2",{},"Keys"),v("label",{className:"find",htmlFor:"find-key"},"Find a key",e),t,i),r=new Map,o=[];e.addEventListener("input",a);function a(){let u=e.value.toLowerCase().split(/\s+/).filter(Boolean),d=0;for(let{fact:f,element:p}of r.values()){let x=`${f.key.replaceAll("_"," ")} ${f.key} ${f.meaning}`.toLowerCase();p.hidden=!u.every(m=>x.includes(m)),d+=p.hidden?0:1}for(let f of o){f.element.hidden=f.fields.every(p=>p.element.hidden);for(let{heading:p,fields:x}of f.parts)p.hidden=x.every(m=>m.element.hidden);u.length&&!f.element.hidden&&(f.element.open=!0)}t.textContent=u.length?`${d} of ${r.size} keys`:`${r.size} keys; enter values with units, as in a design file`}function l(u,d,f){let p=new Map(f.keys.map(x=>[x.key,x]));u3(u.keys,r)||c(u);for(let x of u.keys)r.get(x.key).show(x,d[x.key],p.get(x.key));for(let x of o)x.count(d);a()}function c(u){let d=new Set(o.length?o.filter(({element:x})=>x.open).map(({name:x})=>x):c3),f=document.activeElement?.dataset?.key;r=new Map(u.keys.map(x=>[x.key,Lv(x,m=>n(x.key,m))])),o=[...new Set(u.keys.map(({key:x})=>x.includes(".")?x.split(".")[0]:""))].sort((x,m)=>(m===""?-1:0)-(x===""?-1:0)).map(x=>h3(x,u,r));for(let x of o)x.element.open=d.has(x.name);i.replaceChildren(...o.map(x=>x.element)),f&&r.get(f)?.input.focus()}function h(u,d,f){let p=r.get(u);if(p){p.reject(f,d);for(let x of o)x.fields.includes(p)&&(x.element.open=!0)}}return{element:s,show:l,reject:h,field:u=>r.get(u)}}function u3(n,e){let t=[...e.keys()],i=(s,r)=>s.key===r&&s.onlyWords===e.get(r).fact.onlyWords;return n.length===t.length&&n.every((s,r)=>i(s,t[r]))}function h3(n,e,t){let i=e.keys.filter(({key:d})=>(d.includes(".")?d.split(".")[0]:"")===n),s=i.map(({key:d})=>t.get(d)),r=v("summary"),o=e.sections[n],a=[],l=[];for(let{key:d}of i){let f=d.split(".").slice(1,-1).join(".");if(f!==(a.at(-1)?.within??"")){let p=e.keys.find(m=>m.key===`${n}.${f}.name`)?.value,x=v("h3",{},`${n}.${f}${p?` · ${p}`:""}`);a.push({within:f,heading:x,fields:[]}),l.push(x)}a.at(-1)?.fields.push(t.get(d)),l.push(t.get(d).element)}let c=o?[v("p",{className:"note"},`${Nt(o).replace(/\.$/,"")}.`)]:[],h=v("details",{},r,...c,...l);function u(d){let f=i.filter(({key:p})=>p in d).length;r.replaceChildren(n?Nt(n):"Name",...f?[v("small",{},` ${f} changed`)]:[])}return{name:n,element:h,fields:s,parts:a.filter(({heading:d})=>d),count:u}}var d3="http://www.w3.org/2000/svg",f3=Math.PI/180;function xl(n,e,...t){let i=document.createElementNS(d3,n);for(let[s,r]of Object.entries(e))i.setAttribute(s,r);return i.append(...t),i}var _l=({kawasaki:n,maekawa:e})=>n===null||n>f3||(e??0)!==0,Wp=n=>_l(n)?"failing":n.maekawa===null?"unknown":"holding",$p=({kawasaki:n})=>n===null?"odd":`${(n*180/Math.PI).toFixed(n>.17?0:2)}°`;function Dv(){let n=v("img",{alt:"the picture that is traced"}),[e,t,i,s,r]=Array.from({length:5},()=>xl("g",{})),o=xl("svg",{class:"trace-drawing",tabindex:"0",role:"application"},e,t,i,s,r),a=v("div",{className:"trace-sheet"},n,o),c={element:v("div",{className:"trace-stage"},a),drawing:o,image:n,width:1,height:1,zoom:1};return Object.defineProperty(c,"unit",{get:()=>c.width/(o.getBoundingClientRect().width||c.width)}),c.size=(h,u)=>{Object.assign(c,{width:h,height:u,zoom:1}),o.setAttribute("viewBox",`-0.5 -0.5 ${h} ${u}`),a.style.aspectRatio=`${h} / ${u}`,a.style.width="100%"},c.magnify=h=>{c.zoom=Math.min(Math.max(c.zoom*h,1),16),a.style.width=`${100*c.zoom}%`},c.pointOf=({clientX:h,clientY:u})=>{let d=o.getBoundingClientRect();return[(h-d.left)/d.width*c.width-.5,(u-d.top)/d.height*c.height-.5]},c.show=h=>{let{unit:u}=c,{pattern:d,selected:f,conditions:p,doubts:x}=h,m=([b,T],[P,C],D)=>xl("line",{x1:b,y1:T,x2:P,y2:C,class:D}),g=([b,T],P,C)=>xl("circle",{cx:b,cy:T,r:P*u,class:C}),_=([b,T],P,C)=>xl("text",{x:b+8*u,y:T-8*u,"font-size":13*u,class:C},P);e.replaceChildren(...x.lines.map(([b,T])=>m(b,T,"doubtful")),...x.places.map(b=>g(b,9,"doubtful"))),t.replaceChildren(...d.edges.flatMap(([b,T],P)=>{let C=[d.vertices[b],d.vertices[T]],D=f.edge===P?" chosen":"";return[m(...C,`ground${D}`),m(...C,`crease crease-${d.letters[P]}`)]}));let w=new Map(p.map(b=>[b.vertex,Wp(b)]));i.replaceChildren(...h.points.map(b=>g(b,2.5,"junction")),...d.vertices.map((b,T)=>g(b,4.5,`vertex ${w.get(T)??""}${f.vertex===T?" chosen":""}`))),s.replaceChildren(...p.filter(_l).map(b=>{let T=b.maekawa?`, |M−V| = ${b.maekawa+2}`:"";return _(d.vertices[b.vertex],`${$p(b)}${T}`,"condition")}));let{cursor:S,pen:A,aim:M,clicks:y}=h;r.replaceChildren(...y.length>1?y.map((b,T)=>m(b,y[(T+1)%y.length],"measured")):[],...y.map((b,T)=>g(b,6,`click${f.click===T?" chosen":""}`)),...A&&M?[m(A,M.point,"pen")]:[],...A?[g(A,6,"pen")]:[],...M?.what?[g(M.point,9,"aim")]:[],...S?p3(S,14*u,m):[])},c}var p3=([n,e],t,i)=>[i([n-t,e],[n+t,e],"cursor"),i([n,e-t],[n,e+t],"cursor")];var m3=["vertex","creases","alternating sum of sectors (Kawasaki)","|mountains − valleys| (Maekawa)","within 1° and exactly 2"],g3={failing:"no",holding:"yes",unknown:"not known"};function kv(n){let e=v("summary"),t=v("tbody"),i=v("thead",{},v("tr",{},...m3.map(l=>v("th",{scope:"col"},l)))),s=v("div",{className:"table",tabIndex:0,role:"group","aria-label":"conditions of flat folding"},v("table",{},i,t)),r=v("details",{className:"trace-conditions",open:!0},e,s),o=[];function a(l,c){if(o[0]===l&&o[1]===c)return;o=[l,c];let h=l.filter(_l).length,u=c?"":" Angles are those in the picture until the scale is set.",d=`${l.length} ${l.length===1?"vertex":"vertices"} inside the sheet`;e.textContent=`Flat folding: ${l.length?`${h} of ${d} fail${h===1?"s":""}.`:"no vertices inside the sheet yet."}${u}`,s.hidden=!l.length,t.replaceChildren(...l.map(f=>{let{vertex:p,creases:x,maekawa:m}=f,g=v("button",{type:"button",title:"select this vertex"},String(p));g.addEventListener("click",()=>n(p));let _=f.kawasaki===null,w=x?m===null?"unassigned edges":m+2:"no creases",S=[g,x,_?"never flat: odd number":$p(f),w,g3[Wp(f)]];return v("tr",_l(f)?{className:"failing"}:{},...S.map(A=>v("td",{},typeof A=="number"?String(A):A)))}))}return{element:r,show:a}}var Gr=(n,e)=>Math.hypot(e[0]-n[0],e[1]-n[1]);function ta(n,[e,t]){if(!n)return[e,-t];let[i,s,r]=n.map(([o,a,l])=>o*e+a*t+l);return[i/r,s/r]}function x3([[n,e,t],[i,s,r],[o,a,l]]){let c=n*(s*l-r*a)-e*(i*l-r*o)+t*(i*a-s*o);return[[s*l-r*a,t*a-e*l,e*r-t*s],[r*o-i*l,n*l-t*o,t*i-n*r],[i*a-s*o,e*o-n*a,n*s-e*i]].map(h=>h.map(u=>u/c))}function yl(n,e,t){let i=[e[0]-n[0],e[1]-n[1]],s=i[0]**2+i[1]**2,r=s?((t[0]-n[0])*i[0]+(t[1]-n[1])*i[1])/s:0,o=Nh(n,e,Math.min(Math.max(r,0),1));return{share:r,near:o,distance:Gr(o,t)}}var Nh=(n,e,t)=>[n[0]+t*(e[0]-n[0]),n[1]+t*(e[1]-n[1])];function Ov([n,e],[t,i]){let[s,r]=[[e[0]-n[0],e[1]-n[1]],[i[0]-t[0],i[1]-t[1]]],o=s[0]*r[1]-s[1]*r[0];if(Math.abs(o)<1e-9*Math.hypot(...s)*Math.hypot(...r))return null;let a=[t[0]-n[0],t[1]-n[1]],l=(a[0]*r[1]-a[1]*r[0])/o,c=(a[0]*s[1]-a[1]*s[0])/o;return l>0&&l<1&&c>0&&c<1?[l,c]:null}function Xp(n){let e=[0,1].map(o=>n.reduce((a,l)=>a+l[o],0)/n.length),t=([o,a])=>Math.atan2(a-e[1],o-e[0]),i=[...n].sort((o,a)=>t(o)-t(a)),s=i.map(([o,a])=>o+a),r=s.indexOf(Math.min(...s));return[...i.slice(r),...i.slice(0,r)]}function Uv(n,e){let t=n?x3(n):[[1,0,0],[0,-1,0],[0,0,1]];return i=>ta(t,e(ta(n,i)))}function Fv([n,e],[t,i]){let s=(t-n)**2+(i-e)**2,[r,o]=[((t-n)**2-(i-e)**2)/s,2*(t-n)*(i-e)/s];return a=>[n+r*(a[0]-n)+o*(a[1]-e),e+o*(a[0]-n)-r*(a[1]-e)]}function Bv([n,e],t){let[i,s]=[Math.cos(t),Math.sin(t)];return r=>[n+i*(r[0]-n)-s*(r[1]-e),e+s*(r[0]-n)+i*(r[1]-e)]}var zv={vertices:[],edges:[],letters:[]},Hr={M:"mountain",V:"valley",F:"flat",B:"border",C:"cut",U:"unassigned"},Dh=({vertices:n,edges:e,letters:t})=>({vertices:[...n],edges:[...e],letters:[...t]}),Vv=([n,e],t,i)=>n===t&&e===i||n===i&&e===t;function ks({vertices:n},e,t){let i=-1;for(let[s,r]of n.entries())Gr(r,e)<=(i<0?t:Gr(n[i],e))&&(i=s);return i}function kh({vertices:n,edges:e},t,i){let s={number:-1,distance:i};for(let[r,[o,a]]of e.entries()){let l=yl(n[o],n[a],t);l.distance<=s.distance&&(s={number:r,distance:l.distance})}return s.number}function qp(n,e,t,i){let s=ks(n,t,i);if(s>=0)return{point:n.vertices[s],what:"vertex"};let r=ks({vertices:e},t,i);if(r>=0)return{point:e[r],what:"junction"};let o=kh(n,t,i/2);if(o<0)return{point:t,what:""};let[a,l]=n.edges[o];return{point:yl(n.vertices[a],n.vertices[l],t).near,what:"crease"}}function vl(n,e,t){let i=ks(n,e,t);if(i>=0)return[n,i];let s=kh(n,e,t),r=Dh(n);r.vertices.push(e);let o=r.vertices.length-1;return s>=0&&Gv(r,s,o),[r,o]}function Gv(n,e,t){let[i,s]=n.edges[e];n.edges[e]=[i,t],n.edges.push([t,s]),n.letters.push(n.letters[e])}function Yp(n,e,t,i,s){if(e===t)return n;let r=Dh(n),o=[r.vertices[e],r.vertices[t]];for(let[c,[h,u]]of[...r.edges.entries()]){if([h,u].some(f=>yl(...o,r.vertices[f]).distance<=s))continue;let d=Ov(o,[r.vertices[h],r.vertices[u]]);!d||ks(r,Nh(...o,d[0]),s)>=0||(r.vertices.push(Nh(...o,d[0])),Gv(r,c,r.vertices.length-1))}let a=[...r.vertices.entries()].filter(([c])=>c!==e&&c!==t).map(([c,h])=>({number:c,...yl(...o,h)})).filter(({number:c,share:h,distance:u})=>u<=s&&h>0&&h<1&&Hv(r,c)).sort((c,h)=>c.share-h.share),l=[e,...a.map(({number:c})=>c),t];for(let[c,h]of l.slice(1).entries()){let u=l[c],d=r.edges.findIndex(f=>Vv(f,u,h));d>=0?r.letters[d]=i:(r.edges.push([u,h]),r.letters.push(i))}return r}var Hv=({edges:n},e)=>n.some(t=>t.includes(e));function Wv(n,e,t,i){let s={vertices:n.vertices.map((l,c)=>c===e?[1/0,1/0]:l)},r=ks(s,t,i),o=Dh(n);if(o.vertices[e]=r<0?t:n.vertices[r],r<0)return o;o.edges=o.edges.map(l=>l.map(c=>c===e?r:c));let a=o.edges.map((l,c)=>l[0]!==l[1]&&o.edges.findIndex(h=>Vv(h,...l))===c);return bl(Zp(o,a),[e])}var Zp=({vertices:n,edges:e,letters:t},i)=>({vertices:n,edges:e.filter((s,r)=>i[r]),letters:t.filter((s,r)=>i[r])});function bl(n,e){let t=new Set(e),i=Zp(n,n.edges.map(o=>!o.some(a=>t.has(a)))),s=[],r=0;for(let o of i.vertices.keys())s.push(t.has(o)?-1:r++);return{vertices:i.vertices.filter((o,a)=>!t.has(a)),edges:i.edges.map(o=>o.map(a=>s[a])),letters:i.letters}}function $v(n,e){let t=n.edges[e],i=Zp(n,n.edges.map((s,r)=>r!==e));return bl(i,t.filter(s=>!Hv(i,s)))}function Xv(n,e,t){let i=Dh(n);return i.letters[e]=t,i}function qv(n,e,t){let i=n;for(let s of e)for(let[r,[o,a]]of n.edges.entries()){let l,c;[i,l]=vl(i,s(n.vertices[o]),t),[i,c]=vl(i,s(n.vertices[a]),t),i=Yp(i,l,c,n.letters[r],t)}return i}function jp({vertices:n,edges:e,letters:t},i){let s=n.map(a=>ta(i,a)),r=n.map(()=>[]);for(let[a,[l,c]]of e.entries())r[l].push({to:s[c],letter:t[a]}),r[c].push({to:s[l],letter:t[a]});let o=[];for(let[a,l]of r.entries()){if(!l.length||l.some(({letter:x})=>x==="B"||x==="C"))continue;let c=l.filter(({letter:x})=>x!=="F"),[h,u]=s[a],d=c.map(({to:x})=>Math.atan2(x[1]-u,x[0]-h)).sort((x,m)=>x-m),f=d.map((x,m)=>(d[m+1]??d[0]+2*Math.PI)-x),p=x=>c.filter(m=>m.letter===x).length;o.push({vertex:a,creases:c.length,kawasaki:c.length%2?null:Math.abs(f.reduce((x,m,g)=>x+(g%2?-m:m),0)),maekawa:p("U")?null:c.length?Math.abs(p("M")-p("V"))-2:0})}return o}function Yv(n){let e={pattern:zv,before:[],after:[]},t=i=>n(e.pattern=i);return Object.assign(e,{put(i){i!==e.pattern&&(e.before.push(e.pattern),e.after=[],t(i))},undo(){e.before.length&&(e.after.push(e.pattern),t(e.before.pop()))},redo(){e.after.length&&(e.before.push(e.pattern),t(e.after.pop()))},clear(){[e.before,e.after]=[[],[]],t(zv)}})}var Zv={mouse:9,touch:22,pen:12,keys:9},_3=5,y3=12,Sl=1e-6,_i={vertex:-1,edge:-1,click:-1};function jv(n,e,t,{show:i,say:s,clicked:r}){let{drawing:o}=n,a=null,l=b=>(Zv[b]??Zv.mouse)*n.unit,c=(b,T)=>qp(t.pattern,e.points,b,T),h=([b,T])=>[Math.min(Math.max(b,0),n.width-1),Math.min(Math.max(T,0),n.height-1)];function u(b,T){let P=ks(t.pattern,b,T);e.selected={..._i,vertex:P,edge:P<0?kh(t.pattern,b,T):-1},s(d())}function d(){let{vertex:b,edge:T}=e.selected;return b>=0?`Vertex ${b} is selected.`:T>=0?`Edge ${T} is selected: ${Hr[t.pattern.letters[T]]}.`:""}function f(b,T){let P=t.pattern,[C,D]=[-1,-1];b&&([P,C]=vl(P,b,Sl)),[P,D]=vl(P,T,Sl),b&&C!==D&&(P=Yp(P,C,D,e.letter,n.unit)),t.put(P),e.selected={..._i,vertex:D},s(b?`A ${Hr[e.letter]} edge to vertex ${D} is drawn.`:`Vertex ${D} is drawn.`)}function p(b,T){let P=ks({vertices:e.clicks},b,T);P<0&&e.clicks.length===e.most&&(e.clicks=[]),P<0&&(e.clicks=[...e.clicks,b]),e.selected={..._i,click:P<0?e.clicks.length-1:P},s(`Point ${e.selected.click+1} of ${e.most}.`)}o.addEventListener("pointerdown",b=>{if(a||b.pointerType==="mouse"&&b.button!==0)return;o.setPointerCapture?.(b.pointerId),o.focus({preventScroll:!0});let T=l(b.pointerType),P=n.pointOf(b);e.cursor=null,a={id:b.pointerId,at:P,reach:T,dragging:!1,was:t.pattern},e.tool==="draw"&&([e.pen,e.aim]=[null,c(h(P),T)]),e.tool==="move"&&u(P,T),e.tool==="scale"&&p(c(h(P),T).point,T),a.start=e.aim?.point??P,i()}),o.addEventListener("pointermove",b=>{let T=h(n.pointOf(b)),P=l(b.pointerType);if(!a)return e.aim=e.tool==="move"||e.cursor?null:c(T,P),i();if(b.pointerId===a.id&&(a.dragging||=Gr(T,a.at)>_3*n.unit,!!a.dragging)){if(e.tool==="draw"&&([e.pen,e.aim]=[a.start,c(T,P)]),e.tool==="move"&&e.selected.vertex>=0){let{vertex:C}=e.selected;e.aim=qp(bl(t.pattern,[C]),e.points,T,P),e.preview={...t.pattern,vertices:t.pattern.vertices.with(C,e.aim.point)}}return e.tool==="scale"&&(e.clicks=e.clicks.with(e.selected.click,c(T,P).point)),i()}}),o.addEventListener("pointerup",b=>{if(b.pointerId!==a?.id)return;let{dragging:T,start:P}=a;a=null,e.tool==="draw"&&e.aim&&f(T?P:null,e.aim.point),e.tool==="move"&&T&&e.selected.vertex>=0&&x(e.selected.vertex,e.aim.point),e.tool==="scale"&&r(),Object.assign(e,{pen:null,aim:null,preview:null}),i()}),o.addEventListener("pointercancel",()=>{a=null,Object.assign(e,{pen:null,aim:null,preview:null}),i()});function x(b,T){let P=t.pattern.vertices.length;t.put(Wv(t.pattern,b,T,Sl)),t.pattern.vertices.length<P&&(e.selected=_i),s(t.pattern.vertices.length<P?"Two vertices are one now.":`Vertex ${b} is moved.`)}function m(){let{vertex:b,edge:T,click:P}=e.selected;if(b>=0)t.put(bl(t.pattern,[b]));else if(T>=0)t.put($v(t.pattern,T));else if(P>=0)e.clicks=e.clicks.filter((C,D)=>D!==P),r();else return;e.selected=_i,s("Deleted."),i()}function g(b){e.letter=b,e.selected.edge>=0&&t.put(Xv(t.pattern,e.selected.edge,b)),s(e.selected.edge>=0?d():`The next edge is drawn as ${Hr[b]}.`),i()}function _([b,T],P){let{vertex:C,click:D}=e.selected,U=N=>([z,W])=>h([z+b*N*n.unit,W-T*N*n.unit]);e.tool==="move"&&C>=0?x(C,U(P?10:1)(t.pattern.vertices[C])):e.tool==="scale"&&D>=0&&!e.cursor?(e.clicks=e.clicks.with(D,U(P?10:1)(e.clicks[D])),r()):w(U(P?50:5)(e.cursor??[n.width/2,n.height/2]))}function w(b){e.cursor=b,e.aim=c(b,l("keys")),s(`Cursor at ${b.map(T=>T.toFixed(0)).join(", ")} pixels${e.aim.what?`, at a ${e.aim.what}`:""}.`)}function S(b){let{vertices:T}=t.pattern,P=([,N])=>Math.round(N/(y3*n.unit)),C=e.points.filter(N=>ks(t.pattern,N,Sl)<0),D=[...T,...C].sort((N,z)=>P(N)-P(z)||N[0]-z[0]);if(!D.length)return;let U=e.cursor?D.findIndex(N=>Gr(N,e.cursor)<Sl):-1;w(D[(U+(b?1:U<0?0:-1)+D.length)%D.length])}function A(){e.cursor||w([n.width/2,n.height/2]);let{point:b}=e.aim=c(e.cursor,l("keys"));if(e.tool==="move")return u(e.cursor,l("keys"));if(e.tool==="scale")return p(b,l("keys")),r();f(e.pen,b),e.pen=b}function M(){[e.pen,e.aim,e.cursor,e.selected]=[null,null,null,_i],s("")}function y(b){(b?t.redo:t.undo)(),s(b?"Done again.":"Undone.")}return o.addEventListener("keydown",b=>{let{key:T}=b,P=T.toUpperCase(),C=b.ctrlKey||b.metaKey;if(!b.altKey){if(C&&P==="Z")y(b.shiftKey);else if(C&&P==="Y")y(!0);else{if(C)return;if(T in dr)_(dr[T],b.shiftKey);else if(T==="Delete"||T==="Backspace")m();else if(T==="Enter"||T===" ")A();else if(T==="Escape")M();else if(P==="N"||P==="P")S(P==="N");else if(P in Hr)g(P);else return}b.preventDefault(),i()}}),{remove:m,assign:g,again:y}}var v3={draw:"Draw",move:"Select and move",scale:"Set the scale"};function Kv(n,e,t,i,s=()=>[]){let r=Object.entries(t).map(([o,a])=>{let l=v("input",{type:"radio",name:e,value:o});return l.addEventListener("change",()=>i(o)),[l,v("label",{},l,...s(o),` ${a}`)]});return{element:v("fieldset",{className:"trace-choice"},v("legend",{},n),...r.map(([,o])=>o)),show:o=>r.forEach(([a])=>a.checked=a.value===o)}}var Jv=n=>Kv("Tool","trace-tool",v3,n);function Qv(n){let e=Object.fromEntries(Object.entries(Hr).map(([t,i])=>[t,`${Nt(i)} (${t})`]));return Kv("Edges","trace-kind",e,n,t=>{let i=document.createElementNS("http://www.w3.org/2000/svg","svg"),s=document.createElementNS("http://www.w3.org/2000/svg","line");for(let[r,o]of Object.entries({x1:1,y1:5,x2:29,y2:5,class:`crease crease-${t}`}))s.setAttribute(r,o);return i.setAttribute("viewBox","0 0 30 10"),i.setAttribute("aria-hidden","true"),i.append(s),[i]})}function eb(n){let e=(t,i,s,r)=>{let o=v("input",{type:"range",min:0,max:i,value:s});return o.addEventListener("input",()=>r(o.value)),r(s),v("label",{},`${t} `,o)};return v("div",{className:"choices"},e("Opacity of the picture",100,60,t=>n.style.opacity=t/100),e("Brightness",200,100,t=>n.style.filter=`brightness(${t}%)`))}function Oh(n,{id:e,placeholder:t,button:i,note:s=""},r){let o=v("input",{type:"text",id:e,placeholder:t,size:13,spellcheck:!1}),a=v("button",{type:"button"},i),l=v("span",{},n),c=()=>r(o.value.trim());return a.addEventListener("click",c),o.addEventListener("keydown",({key:u})=>u==="Enter"&&c()),{element:v("div",{className:"trace-entry"},v("label",{htmlFor:e},l,o),a,...s?[v("p",{className:"note"},s)]:[]),input:o,button:a,label:l}}function Ti(n,e,t){let i=v("button",{type:"button",title:e},n);return i.addEventListener("click",t),i}var b3=800,nb=/\.(png|jpe?g)$/i,Kp={lines:[],places:[],words:[]},tb="Click for a vertex, drag for an edge. Keys: arrows lead a cursor or move what is selected (shift: further), N and P lead to the next and the previous vertex or junction, Enter draws from the last point, Escape ends that, letters choose the kind, Delete deletes, ctrl+Z and ctrl+Y undo and redo.",ib=({name:n})=>nb.test(n);function sb(n,e){let t=Dv(),i={tool:"draw",letter:"B",points:[],selected:_i,cursor:null,pen:null,aim:null,preview:null,clicks:[],most:2,scale:null,matrix:null,doubts:Kp,picture:null,conditions:[]},s=Yv(_),r=Jv(we=>S(we)),o=Qv(we=>u.assign(we)),a=v("p",{className:"note trace-said",role:"status"}),l=v("p",{className:"wrong",role:"alert"}),c=v("div",{className:"notes"}),h=kv(we=>{S("move"),i.selected={..._i,vertex:we},w(),t.drawing.focus()}),u=jv(t,i,s,{show:w,say:we=>a.textContent=we,clicked:g}),d=S3(g,we=>{[i.most,i.clicks,i.selected]=[we,[],_i],g(),S("scale")}),f=0,p=0;async function x(we){let Fe=URL.createObjectURL(we);try{await v("img",{src:Fe}).decode()}catch{URL.revokeObjectURL(Fe),M(`${we.name} cannot be displayed: need a PNG or JPEG picture`);return}URL.revokeObjectURL(t.image.src),t.image.src=Fe,await t.image.decode();let Ze={name:we.name,text:await w3(we)};Object.assign(i,{picture:Ze,points:[],doubts:Kp,clicks:[],scale:null,matrix:null,cursor:null}),s.clear(),t.size(t.image.naturalWidth,t.image.naturalHeight),At.hidden=!1,c.replaceChildren(),d.say(""),S("draw"),M(""),a.textContent="Searching for lines to which clicks snap …";let B=await Qn("picture-junctions",m());if(i.picture===Ze){if(B.refused){At.hidden=!0,i.picture=null,M(`${we.name} is not opened: ${B.refused}`);return}i.points=B.points,a.textContent=B.points.length?`Clicks snap to ${B.points.length} junctions of lines and corners.`:`Clicks snap to vertices only: ${B.reason||"no junctions of lines were found"}.`,w()}}let m=()=>({picture:i.picture.text,name:i.picture.name});async function g(){let{clicks:we,most:Fe}=i,Ze=d.text;if([i.scale,i.matrix]=[null,null],d.say(we.length<Fe?`${we.length} of ${Fe} points are clicked.`:Ze?"":d.missing),we.length===Fe&&Ze){let de={points:Fe===4?Xp(we):we,size:Ze,width:t.width,height:t.height},ke=await Qn("picture-scale",de);if(i.clicks!==we)return;if(ke.refused)d.say(ke.refused,!0);else{[i.scale,i.matrix]=[de,ke.matrix];let Qe=ke.estimated?` The shorter side is estimated from ${ke.estimated}; give width and height.`:"";d.say(`${Fe===4?`The rectified sheet is ${ke.size}`:`The length is ${ke.size}`}; one pixel is ${ke.pixel}.${Qe}`)}}_()}function _(){let{pattern:we}=s;(i.selected.vertex>=we.vertices.length||i.selected.edge>=we.edges.length)&&(i.selected=_i),i.conditions=jp(we,i.matrix),clearTimeout(f),$e.checked&&i.scale&&we.edges.length>2&&(f=setTimeout(()=>N(!0),b3)),w()}function w(){o.show(i.letter),r.show(i.tool);let we=i.preview?jp(i.preview,i.matrix):i.conditions;h.show(we,i.matrix!==null),t.show({...i,pattern:i.preview??s.pattern,conditions:we,clicks:i.tool==="scale"?i.clicks:[]});let{vertex:Fe,edge:Ze,click:B}=i.selected;z.disabled=!s.before.length,W.disabled=!s.after.length,H.disabled=Fe<0&&Ze<0&&B<0;let de=i.scale&&s.pattern.edges.length>2;for(let ke of[J.button,be,Se])ke.disabled=!de;xe.disabled=ee.disabled=Ze<0,he.disabled=Fe<0}function S(we){Object.assign(i,{tool:we,pen:null,aim:null,selected:_i}),d.element.hidden=we!=="scale",o.element.hidden=we==="scale",w()}let A=()=>{let{vertices:we,edges:Fe,letters:Ze}=s.pattern;return{scale:i.scale,name:i.picture.name,vertices:we,edges:Fe,letters:Ze}};function M(we){a.textContent="",l.textContent=we&&!we.endsWith(".")?`${we}.`:we;let Fe=/edges_vertices\[(\d+)\]/.exec(we)?.[1];Fe!==void 0&&(i.selected={..._i,edge:Number(Fe)}),w()}async function y(we){let Fe=s.pattern;M(""),a.textContent="Moving the vertices …";let Ze=await Qn("picture-straighten",{...A(),tolerance:we});if(s.pattern!==Fe)return;if(Ze.refused)return void M(Ze.refused);s.put({vertices:Ze.vertices,edges:Ze.edges,letters:Ze.letters});let B=Ze.symmetries.length?`, with ${Ze.symmetries.join(" and ")}`:"";a.textContent=[`Vertices moved by at most ${Ze.largest}: Kawasaki's condition holds at ${Ze.flat} vertices${B}`,...Ze.remarks].join(". ")}async function b(we){let{picture:Fe}=i,Ze=i.clicks.length===4?Xp(i.clicks):null;M(""),a.textContent="Tracing …",te.button.disabled=!0;let B=Ze?Ze.map(([R,q])=>`${R.toFixed(2)},${q.toFixed(2)}`).join(" "):te.flat.checked?"none":"",de=await Qn("picture-trace",{...m(),size:we,corners:B});if(te.button.disabled=!1,i.picture!==Fe)return;if(de.refused)return void M(de.refused);let{points:ke,size:Qe}=de.scale;[i.clicks,i.most]=[ke,ke.length],d.put(ke.length,Qe);let ye=([R,q])=>[de.vertices[R],de.vertices[q]],Et=R=>Object.entries(R).map(([q,ce])=>[Number(q),ce]),ze=Et(de.doubts.edges),Ye=Et(de.doubts.vertices);i.doubts={lines:ze.map(([R])=>ye(de.edges[R])),places:[...Ye.map(([R])=>de.vertices[R]),...de.doubts.points.map(([R,q])=>[R,q])],words:[...de.doubts.whole,...ze.map(([R,q])=>`Edge ${R}: ${q}.`),...Ye.map(([R,q])=>`Vertex ${R}: ${q}.`)]},c.replaceChildren(...i.doubts.words.length?[T()]:[]),s.put({vertices:de.vertices,edges:de.edges,letters:de.letters}),await g();let k=i.doubts.words.length;a.textContent=`Traced ${de.vertices.length} vertices and ${de.edges.length} edges of a pattern of ${de.said}; ${k?`${k} doubts are listed below`:"nothing is doubtful"}.`}function T(){let we=Ti("Remove the marks of doubts","the list and the orange marks",()=>{i.doubts=Kp,c.replaceChildren(),w()});return v("details",{open:!0},v("summary",{},"Doubts"),v("ul",{},...i.doubts.words.map(Fe=>v("li",{},Fe))),we)}function P(we){let{vertex:Fe,edge:Ze}=i.selected,B=ke=>ta(i.matrix,s.pattern.vertices[ke]),de=Ze>=0?s.pattern.edges[Ze].map(B):[B(Fe)];s.put(qv(s.pattern,we(...de).map(ke=>Uv(i.matrix,ke)),2*t.unit))}async function C(we=!1){let Fe=await Qn("picture-pattern",A());return Fe.refused?M(`No pattern yet: ${Fe.refused}`):(l.textContent="",(!we||Fe.remarks.length)&&(a.textContent=[`The pattern is ${Fe.size}`,...Fe.remarks].join(". "))),Fe.refused?null:Fe}async function D(){let we=await C();we&&ps(new Blob([we.fold],{type:"application/json"}),U())}let U=()=>`${i.picture.name.replace(nb,"").replace(/[^\p{L}\p{N}._ -]/gu,"_").slice(0,60)||"picture"}.fold`;async function N(we=!1){let Fe=p+=1,Ze=await C(we);!Ze||Fe!==p||await n({design:"",files:[{name:U(),text:Ze.fold}],unit:""})||(en.append(ct),ot())}let z=Ti("Undo","ctrl+Z",()=>u.again(!1)),W=Ti("Redo","ctrl+Y",()=>u.again(!0)),H=Ti("Delete","what is selected",()=>u.remove()),se=Ti("Enlarge","the picture and the drawing",()=>We(1.5)),Y=Ti("Reduce","the picture and the drawing",()=>We(1/1.5)),J=Oh("Move vertices by at most ",{id:"trace-tolerance",placeholder:"0.5 mm",button:"Make flat-foldable",note:"The vertices move as little as possible to Kawasaki's condition, and to the symmetries and straight lines that hold within this length."},y),te=Oh("Width and height of the sheet ",{id:"trace-size",placeholder:"29.7 x 21 cm",button:"Trace automatically"},b);te.flat=v("input",{type:"checkbox"}),te.element.append(v("label",{},te.flat," scan without perspective: the size is that of the pattern")),te.element.append(v("p",{className:"note"},"Four corners under “Set the scale” are used if they are clicked; otherwise they are searched. The result replaces the drawing; undo restores it."));let pe=v("input",{type:"number",id:"trace-copies",min:2,max:60,value:4}),fe=()=>Math.min(Math.max(Math.round(pe.valueAsNumber)||2,2),60),ee=Ti("Mirror at the selected edge","all edges",()=>P((we,Fe)=>[Fv(we,Fe)])),he=Ti("Repeat around the selected vertex","all edges, by equal angles of a whole turn",()=>{let we=fe();P(Fe=>Array.from({length:we-1},(Ze,B)=>Bv(Fe,2*Math.PI*(B+1)/we)))}),xe=Ti("Repeat along the selected edge","all edges, by its length",()=>{let we=fe();P(([Fe,Ze],[B,de])=>Array.from({length:we-1},(ke,Qe)=>([ye,Et])=>[ye+(Qe+1)*(B-Fe),Et+(Qe+1)*(de-Ze)]))}),be=Ti("Download as FOLD","with the unit and the scale of the picture",D),Se=Ti("Fold it","open the pattern as the design of the workbench",()=>N()),$e=v("input",{type:"checkbox",id:"trace-follow"});$e.addEventListener("change",_);function ot(){ct.isConnected&&e.parentElement!==ct&&ct.append(e)}function We(we){t.magnify(we),w()}let lt=v("input",{type:"file",id:"trace-file",accept:".png,.jpg,.jpeg",className:"spoken"});lt.addEventListener("change",()=>{lt.files.length&&x(lt.files[0]),lt.value=""});let ct=v("div",{className:"trace-side",role:"group","aria-label":"the folded sheet"}),et=(we,...Fe)=>v("fieldset",{className:"trace-group"},v("legend",{},we),...Fe);t.drawing.setAttribute("aria-label",`the drawing over the picture. ${tb}`);let $t=v("div",{className:"trace-groups"},et("Result",v("div",{className:"choices"},Se,be),v("label",{},$e," fold it again after every change")),et("Trace automatically",te.element),et("Flat-foldability",J.element),et("Symmetric copies",v("div",{className:"choices"},ee,he,xe,v("label",{htmlFor:"trace-copies"},"number in all ",pe)))),Bt=v("p",{className:"note"},tb),en=v("div",{className:"trace-panes"},v("div",{},t.element,a,Bt,$t,c,h.element)),At=v("div",{hidden:!0},v("div",{className:"trace-tools"},r.element,o.element,d.element),v("div",{className:"choices"},z,W,H,se,Y,eb(t.image)),en),dn=v("div",{className:"choices opening"},v("span",{className:"choosing"},lt,v("label",{className:"button",htmlFor:"trace-file"},"Choose a picture …")),v("p",{className:"note"},"A photograph, scan or drawing of a crease pattern (PNG or JPEG, up to 14 MB), or drop it anywhere on the page.")),vt=v("div",{className:"tracing"},dn,l,At);return new ResizeObserver(w).observe(t.drawing),S("draw"),{element:vt,take:x,state:i,history:s,seen:ot}}function S3(n,e){let t={2:["two points and their distance","Distance ","5 cm"],4:["four corners of a rectangle","Width and height ","29.7 x 21 cm"]},i=v("select",{"aria-label":"what is clicked"},...Object.entries(t).map(([l,[c]])=>v("option",{value:l},c))),s=Oh(t[2][1],{id:"trace-length",placeholder:t[2][2],button:"Apply"},n),r=v("p",{className:"note",role:"status"}),o=v("fieldset",{className:"trace-choice"},v("legend",{},"Scale: click in the picture"),i,s.element,r);function a(l){i.value=String(l),s.label.textContent=t[l][1],s.input.placeholder=t[l][2]}return i.addEventListener("change",()=>{a(Number(i.value)),e(Number(i.value))}),{element:o,get text(){return s.input.value.trim()},get missing(){return`Enter ${i.value==="4"?"the width and height":"the distance"}, such as ${t[i.value][2]}.`},put(l,c){a(l),s.input.value=c},say(l,c=!1){r.textContent=l,r.classList.toggle("fails",c)}}}async function w3(n){let e=new FileReader,t=new Promise((i,s)=>Object.assign(e,{onload:i,onerror:s}));return e.readAsDataURL(n),await t,e.result.slice(e.result.indexOf(",")+1)}function rb(n,e,t,i){let s=v("option",{value:""},e),r=n.filter(({name:p})=>p!==e).map(({name:p,shows:x})=>v("option",{value:p,title:x},p)),o=v("select",{id:"which-design"},s,...r),a=v("input",{type:"file",id:"which-files",multiple:!0,accept:".toml,.fold,.svg,.dxf,.png,.jpg,.jpeg",className:"spoken"}),l=v("input",{type:"text",id:"which-unit",placeholder:"1 cm",size:6,spellcheck:!1}),c="A design (.toml, with the files that it names), a FOLD file or a drawing (.svg, .dxf), or a picture to trace (.png, .jpg), can be dropped anywhere on the page.",h=v("label",{className:"button",htmlFor:"which-files"},"Open files …"),u=v("div",{className:"opening choices"},v("label",{htmlFor:"which-design"},"design ",o),v("span",{className:"choosing"},a,h),v("label",{htmlFor:"which-unit",title:"for a FOLD file or a drawing without a unit"},"unit of a drawing ",l),v("p",{className:"note"},c));o.addEventListener("change",()=>t({design:o.value,files:[],unit:""})),a.addEventListener("change",async()=>{a.files.length&&await f([...a.files]),a.value=""}),l.addEventListener("change",()=>{d&&t({design:"",files:d,unit:l.value.trim()})});let d=null;async function f(p){let x=p.find(ib);if(x){await i(x);return}let m=await Promise.all(p.map(async g=>({name:g.name,text:await g.text()})));d=M3(m),await t({design:"",files:d,unit:l.value.trim()})}return A3(f),{element:u,show({design:p,files:x}){o.querySelector(".sent")?.remove(),x.length&&o.append(v("option",{value:x[0].name,className:"sent"},x[0].name)),o.value=x.length?x[0].name:p,d=x.length?x:null}}}function M3(n){let e=n.filter(({name:i})=>/\.toml$/i.test(i)),t=e.find(({name:i})=>!e.some(s=>s.name!==i&&s.text.includes(i)))??n[0];return[t,...n.filter(i=>i!==t)]}function A3(n){let{body:e}=document,t=i=>{i.dataTransfer?.types.includes("Files")&&(i.preventDefault(),e.classList.add("dropping"))};e.addEventListener("dragenter",t),e.addEventListener("dragover",t),e.addEventListener("dragleave",i=>{i.relatedTarget||e.classList.remove("dropping")}),e.addEventListener("drop",i=>{e.classList.remove("dropping"),i.dataTransfer?.files.length&&(i.preventDefault(),n([...i.dataTransfer.files]))})}function ob(n,{button:e,text:t,title:i},s){let r=v("button",{type:"button",className:"try"},e),o=v("button",{type:"button",hidden:!0},"Stop"),a=v("p",{className:"note",role:"status"},t),l=v("div"),c=v("div",{className:"results"},v("div",{className:"offer"},r,o,a),l),h=null,u=null;async function d(){if(u)return;let x=s(),m=performance.now();u=new AbortController,r.disabled=!0,o.hidden=!1,a.textContent="Starting …";let g=!1;try{let _=await Ih(n,x,u.signal,w=>{w.doing&&(a.textContent=`${w.doing} …`)});_.refused?a.textContent=`No result: ${_.refused}.`:f(_.done,x,(performance.now()-m)/1e3),g=!_.refused}catch{a.textContent="Stopped."}u=null,r.disabled=!1,o.hidden=!0,g&&p()}function f(x,m,g){h=JSON.stringify(m),a.textContent=`Done in ${g.toFixed(g<10?1:0)} s.`;let _=v("a",{href:x,target:"_blank",rel:"noopener"},"Open in a new window"),w=v("iframe",{src:x,title:i,sandbox:"allow-scripts allow-downloads"});l.replaceChildren(v("p",{},_),w)}function p(){h!==null&&!u&&h!==JSON.stringify(s())&&(a.textContent="This result belongs to the design before its last change.")}return r.addEventListener("click",d),o.addEventListener("click",()=>u?.abort()),{element:c,find:d,seen:p}}var E3=1500;function ab(){let n=v("p",{role:"status"}),e=v("p",{className:"wrong",role:"alert"}),t=v("button",{type:"button",hidden:!0},"Stop building"),i=0,s=null;t.addEventListener("click",()=>s?.());function r(o,a=""){clearTimeout(i),t.hidden=!0,n.textContent=o,e.textContent=a}return{element:v("div",{className:"says"},n,t,e),wait(o,a){r(`${o} …`),s=a,a&&(i=setTimeout(()=>t.hidden=!1,E3))},done:o=>r(o),refuse:o=>r("",o.endsWith(".")?o:`${o}.`)}}function lb(){let n=v("a",{className:"button"},"Download the design"),e=v("code"),t=v("pre",{tabIndex:0,role:"group","aria-label":"the command that runs it"},e);return{element:v("div",{className:"taking"},n,t),show(i){n.href=Lh(i.text,"application/toml"),n.download=`${i.name}.toml`,e.textContent=i.command}}}function cb(n){let e=v("div"),t=null;async function i(){let s=n();if(!s)return;let r=JSON.stringify(s);if(r===t)return;t=r,e.querySelector("img")||e.replaceChildren(v("p",{className:"note",role:"status"},"Drawing …"));let o=await Qn("pattern",s);if(t!==r)return;if(o.refused){e.replaceChildren(v("p",{className:"note",role:"status"},`No pattern is drawn: ${o.refused}.`));return}let a=v("img",{src:`data:image/svg+xml;base64,${o.drawing}`,alt:o.said}),l=(h,u,d)=>v("a",{className:"button",download:u,href:d},h),c=Lh(o.fold,"application/json");e.replaceChildren(v("figure",{className:"drawn"},a),v("p",{className:"choices"},l("Drawing as SVG","pattern.svg",a.src),l("Pattern as FOLD","pattern.fold",c)))}return{element:e,seen:i}}function ub(n){let e={},t=0;function i(){if(clearTimeout(t),!Object.keys(e).length)return;let s=e;return e={},n(s)}return{put(s,r){e[s]=r,clearTimeout(t),t=setTimeout(i,250)},hand:i}}function hb(n,e){let t=n.map(({name:o,title:a,element:l},c)=>{l.id=`view-${o}`,l.setAttribute("role","tabpanel"),l.setAttribute("aria-labelledby",`tab-${o}`);let h=v("button",{type:"button",id:`tab-${o}`,role:"tab","aria-controls":l.id},a);return h.addEventListener("click",()=>r(c)),h}),i=v("div",{className:"tabs",role:"tablist","aria-label":e},...t),s=0;function r(o){s=o;for(let[a,l]of t.entries())l.setAttribute("aria-selected",String(a===o)),l.tabIndex=a===o?0:-1,n[a].element.hidden=a!==o;n[o].seen?.()}return i.addEventListener("keydown",({key:o})=>{let a={ArrowRight:s+1,ArrowLeft:s-1,Home:0,End:t.length-1};o in a&&(r((a[o]+t.length)%t.length),t[s].focus())}),{element:v("div",{className:"views-of-bench"},i,...n.map(({element:o})=>o)),choose:o=>r(n.findIndex(a=>a.name===o)),name:(o,a)=>t[n.findIndex(l=>l.name===o)].textContent=a,seen:()=>n[s].seen?.()}}var db=.02;function fb(n,{moving:e,shape:t,names:i,asked:s,held:r}){let o=v("p",{className:"note",role:"status"}),a=v("button",{type:"button","aria-pressed":"false",title:"drag panels as well; otherwise dragging a panel turns the picture"},"drag panels");a.addEventListener("click",()=>a.setAttribute("aria-pressed",String(a.getAttribute("aria-pressed")!=="true")));let l=null,c=!1,h=!0,u=!0;async function d(){if(c||!l)return;let{place:M,target:y}=l,b={...s(),weights:Object.fromEntries(M),target:y,begins:h};l=null,h=!1,c=!0;let T=await Qn("drag",b);c=!1,u||f(T),d()}function f(M){let y=M.refused?`Not dragged: ${M.refused}.`:M.text;M.points&&(e.hold(Kt(M.points,Float32Array)),r(!0)),g.say(y),o.textContent=y}function p(M,y){u&&(h=!0),u=!1,l={place:M,target:y.toArray()},d()}function x(){u=!0,l=null,e.hold(null),r(!1)}function m(M,y){if(a.getAttribute("aria-pressed")!=="true")return null;let b=new Tr;b.setFromCamera(new Je(M,y),n.eye.camera);let{mesh:T}=e,P=null,C=[new G,new G,new G],D=new G,{vertices:U}=n.views[0].shape;for(let z=0;z<T.triangles.length;z+=3){let W=T.triangles.slice(z,z+3);for(let[se,Y]of W.entries())C[se].fromArray(U,3*Y);if(!b.ray.intersectTriangle(...C,!1,D))continue;let H=D.distanceTo(b.ray.origin);(!P||H<P.away)&&(P={away:H,numbers:W,shares:Qi.getBarycoord(D,...C,new G).toArray()})}if(!P)return null;let N=new Map;for(let[z,W]of P.numbers.entries())for(let[H,se]of[[T.between[2*W],1-T.share[W]],[T.between[2*W+1],T.share[W]]])se&&N.set(H,(N.get(H)??0)+se*P.shares[z]);return[...N]}let g=Xu(n,{points:t,movable:i.map(M=>M!==null),between:m,moved:(M,y,b)=>p(M,b),left:x}),_=T3(n,t,i,p,x),w=v("p",{className:"note"},"Drag a vertex: the package computes the equilibrium with the springs of the creases, and the force that holds it."),S=v("div",{className:"drag"},w,o,_.element);return n.element.parentElement.querySelector(".views").prepend(v("span",{className:"panels"},a)),{element:S,end:_.end}}function T3(n,e,t,i,s){let r=Wu(t.map((f,p)=>[f,p]).filter(([f])=>f!==null)),o=$u("drag",{clicked:h,pressed:h}),a=v("button",{type:"button"},"Release"),l=v("p",{className:"note"},"On these buttons, every arrow key drags the vertex by 2 % of the structure's size. It stays there until it is released."),c=null;function h(f){let[p,x]=dr[f],m=Number(r.value);c??=new G().fromArray(e(),3*m);let{camera:g,size:_}=n.eye;c.addScaledVector(new G().setFromMatrixColumn(g.matrixWorld,0),db*_*p),c.addScaledVector(new G().setFromMatrixColumn(g.matrixWorld,1),db*_*x),i([[m,1]],c)}function u(){c=null,s()}return r.addEventListener("change",u),a.addEventListener("click",u),{element:v("details",{className:"push-keys"},v("summary",{},"Drag without a pointer"),v("div",{className:"choices"},v("label",{},"point ",r),o,a),l),end:u}}function pb(n){let e=new Set,t={start:n.start,end:n.end,origins:[0]},i=n.start,s=0;function r(){s||=requestAnimationFrame(()=>{s=0;for(let o of e)o()})}return{get time(){return i},span:t,clipTime:(o,a=i)=>Math.min(n.end,Math.max(n.start,a)),timeAt:o=>t.start+o*(t.end-t.start),wayAt:o=>(o-t.start)/(t.end-t.start||1),onChange(o){return e.add(o),r(),()=>e.delete(o)},seek(o){i=Math.min(t.end,Math.max(t.start,o)),r()}}}var Jp=100;function mb(){let n=v("p",{className:"note",role:"status"}),[e,t,i,s]=["","notes","",""].map(p=>v("div",{className:p})),r=v("div",{className:"folding"},n,e,t,i,s),o={element:r,whole:"structure",share:0,complete:!1,clock:null,path:null},a=null,l=null,c=null;Object.defineProperty(o,"look",{get:()=>c?.look}),o.show=(p,{fresh:x=!1,look:m}={})=>{o.leave(),x&&(o.share=0);let g=l=Object.assign(new AbortController,{wanted:p}),_=performance.now(),w=null;return new Promise(S=>{let A=M=>{M.picture&&(w=M.picture,o.whole=w.whole,(x||!c?.grow)&&u(w,m),a=p,o.complete=!1,n.textContent="Computing the fold path …",S({shown:!0})),M.path&&d(w,M.path,g),M.done&&(n.textContent=R3(o.path,(performance.now()-_)/1e3))};Ih("fold",{...p,share:x?null:o.share},g.signal,A).then(({refused:M})=>{S({refused:M}),!(!M||l!==g)&&(w&&c?.grow&&u(w,m),w&&(n.textContent=`No fold path is shown: ${M}.`))},()=>S({refused:"building was stopped"}))})},o.shows=p=>c!==null&&JSON.stringify(a)===JSON.stringify(p),o.leave=()=>{l?.abort(),l=null},o.resume=()=>{!l||l.wanted===a||(o.leave(),a&&!o.complete&&o.show(a))},o.clear=()=>{o.leave(),h(),a=null};function h(){if(!c)return;let{look:p}=c;c.dispose(),c=null,o.clock=o.path=null;for(let x of[e,t,i,s])x.replaceChildren();return p}function u(p,x){let m=h()??x??ar(),g=Kn(p.clips[0]),{stage:_}=Gu(e,[g],pb(g),{...p,text:`${p.shape}, as built.`},{...m,following:!1});e.setAttribute("aria-label",`the ${p.whole} as built`),c={clip:()=>g,look:_?.eye.look??m,dispose:()=>_?.dispose()}}function d(p,x,m){let g=Kn({...p.clips[0],...x.clips[0]});o.path=x,c?.mine===m&&c.largest===x.energy.largest_J?c.grow(g,x):f(g,x,m,p.points),x.complete&&c.complete(x),o.complete=x.complete}function f(p,x,m,g){let _=e.contains(document.activeElement),w=c?.clip(),S=h()??ar(),A=C3(p);w?.mesh.pointCount===p.mesh.pointCount&&A.lend(w);let M=Bi([A],x.spans);M.seek(Jp*o.share);let y=ur(e,[A],M,x,S,!1);y.stage?.eye.aim(),A.lend(null);let b=null,T=()=>{o.share!==M.time/Jp&&b?.end(),o.share=M.time/Jp},P=[()=>y.dispose(),M.onChange(T)];c={mine:m,clip:A.now,look:y.stage?.eye.look??S,largest:x.energy.largest_J,dispose:()=>P.forEach(C=>C()),grow(C){A.replace(C),M.redraw()},complete({plots:C,notes:D,energy:U,spans:N}){M.setSpan({...N[0]}),t.replaceChildren(...D.map(H=>v("p",{className:"note"},H)));let z=H=>{r.classList.toggle("pulled",H),M.redraw()};if(y.stage){let H=()=>A.pointsAt(M.clipTime(0));b=fb(y.stage,{moving:A,shape:H,names:g,asked:()=>({...a,share:o.share}),held:z}),(e.querySelector(".crease-choice")??e.querySelector(".transport")).after(b.element)}let W=mr(i,C,[A],M);P.push(()=>W.dispose(),hr(s,A,M,U))}},Object.assign(o,{clock:M,stage:y.stage,moving:A,path:x}),_&&e.querySelector("input[type=range]").focus({preventScroll:!0})}return o}function C3(n){let e=n,t=null,i=null,s={now:()=>e,replace:r=>e=r,lend:r=>t=r,hold:r=>i=r,pointsAt(r,o){return i?o?(o.set(i),o):i:(t??e).pointsAt(r,o)},verticesAt:(r,o)=>i?e.verticesOf(i,o):e.verticesAt(r,o)};return new Proxy(s,{get:(r,o)=>s[o]??e[o]})}function R3(n,e){let t=`${e.toFixed(e<10?1:0)} s`;return n.reached?`The fold path was computed in ${t}.`:`The fold path was computed in ${t}; it does not reach its goal.`}var P3=[{name:"live",title:"simulated in time"},{name:"fold",title:"slowly along its path"}];function xb(n,e,t){let i=v("div"),s=mb(),r={element:i,fold:s,panel:null,whole:"structure",refused:"",engine:null},o="live",a=null,l,c;function h(){let g=r.panel?.stage?.eye.look;l=g?{...g,closer:g.closer/qu}:s.look??l,c=r.panel?.pace??c}function u(){h(),r.panel?.leave(),r.panel=null}r.begin=async(g,_)=>{if(!_&&r.panel)return{};let w=await s.show(g,{fresh:_,look:l});return w.shown&&(u(),r.whole=s.whole,i.contains(s.element)||i.replaceChildren(s.element)),w},r.resume=()=>s.resume(),r.show=async g=>{a=g,r.whole=a.bench?.whole??s.whole,r.refused=a.live.refused??"",!r.refused&&o==="live"?await d():await f()};async function d(){let{bench:g,live:_,warnings:w}=a;h();try{let S=await Vo(Kn(g.clips[0]),g,JSON.stringify(_),x,{look:I3(l),pace:c,set:e});u(),s.clear(),i.replaceChildren(p(),S.element,...gb(w)),S.begin(),r.panel=S}catch(S){r.engine?.end(),r.engine=null,r.refused=S.message,await f()}}async function f(){u(),i.replaceChildren(...r.refused?[]:[p()],s.element,...r.refused?[m()]:[],...gb(a.warnings)),s.shows(n())||await s.show(n(),{look:l})}function p(){let g=Ph(r.whole,P3,async _=>{_!==o&&(o=_,await(_==="live"?d():f()),[...i.querySelectorAll(".modes button")].find(w=>w.textContent===o)?.focus())});return g.mark(o),g.element}async function x(g,_){return r.engine?r.engine.take(g,_):(r.engine=await Uo(g,_),r.engine)}function m(){let g=v("p",{className:"note"},`The motion in time is not simulated in this page: ${r.refused}. The package simulates it.`),_=v("button",{type:"button"},"Run it");return _.addEventListener("click",t),v("div",{className:"offer"},_,g)}return r}var I3=n=>n&&{...n,following:!1,closer:qu*n.closer};function gb(n){if(!n.length)return[];let e=t=>`${t.replace(/^[a-z](?=\S* )/,i=>i.toUpperCase()).replace(/\.$/,"")}.`;return[v("h2",{},"What to know"),v("ul",{className:"warnings"},...n.map(t=>v("li",{},e(t))))]}var L3={landscape:{button:"Compute it",text:"Statics computes the equilibria, the barriers between them, and the motion under the drives.",title:"landscape"},run:{button:"Run it",text:"The package simulates the protocol, checks the energy balance and reports the outcome.",title:"run"}};async function _b(n){let e=ab(),t=Promise.resolve(),i=m=>t=t.then(m).catch(g=>e.refuse(g.message)),s=Rv({says:e,reply:f,picture:(m,g)=>u.wing.begin(m,g),model:p,resume:()=>u.wing.resume()}),r=ub(m=>i(()=>s.slide(m))),o=null,a=m=>(o=m,i(()=>o===m&&s.open(m,{}))),l=m=>(o=m,i(async()=>{if(o!==m)return"a later design is opened";let{asked:g}=s,_=g?.files[0]?.name===m.files[0].name,w=_?g.settings:{},S=await s.open(m,w,!_);return S&&Object.keys(w).length?s.open(m,{}):S})),c=rb(n.designs,n.opened,a,m=>(u.tabs.choose("trace"),u.tracing.take(m))),h=Nv((m,g)=>{r.hand(),i(()=>s.change(m,g))}),u=D3(s,r,a,l),d=lb();function f({asked:m,base:g,reply:_,rejected:w}){document.title=`${_.title}: workbench`,document.querySelector("h1").textContent=_.title,c.show(m),h.show(_,m.settings,g);for(let[S,{text:A,why:M}]of w)h.reject(S,A,M);u.file.show(_),d.show(_),u.tabs.seen()}async function p(m){await u.wing.show(m),u.tabs.name("wing",Nt(u.wing.whole))}let x=v("div",{className:"masthead"},c.element,d.element,e.element);return document.getElementById("workbench").append(x,h.element,u.tabs.element),u.tabs.choose("wing"),await i(()=>N3(s,n)),Object.assign(s,{wing:u.wing,tracing:u.tracing,idle:()=>t})}async function N3(n,e){let t=Pv();t&&!await n.open({design:t.design,files:t.files,unit:t.unit},t.settings)||await n.open({design:"",files:[],unit:""},e.settings)}function D3(n,e,t,i){let s=()=>n.asked,r=Object.fromEntries(Object.entries(L3).map(([d,f])=>[d,ob(d,f,s)])),o=xb(s,e.put,()=>{u.choose("run"),r.run.find()}),a=cb(s),l=Iv(d=>t({design:"",files:[{name:`${n.reply?.name??"design"}.toml`,text:d}],unit:""})),c=v("div",{},o.element),h=sb(i,o.element),u=hb([{name:"wing",title:"Structure",element:c,seen:()=>o.element.parentElement!==c&&c.append(o.element)},{name:"sheet",title:"Pattern",...a},{name:"trace",title:"Trace",element:h.element,seen:h.seen},{name:"landscape",title:"Landscape",...r.landscape},{name:"run",title:"Run",...r.run},{name:"file",title:"File",element:l.element}],"views of the design");return{tabs:u,wing:o,file:l,tracing:h}}var k3={run:zp,compare:_y,curves:zp,study:Jy,goals:Qy,parts:vv,bench:Ux,workbench:_b},Qp=JSON.parse(document.getElementById("data").textContent);bm(Qp.reading_units);function yb(n){let e=`Moving pictures cannot be shown in this browser (${n.message}); all numbers are below.`;throw document.querySelector("main").prepend(v("p",{className:"note",role:"alert"},e)),n}function vb(n){window.forficula=n}try{let n=k3[Qp.kind](Qp);n instanceof Promise?n.then(vb,yb):vb(n)}catch(n){yb(n)}vm();zo();})();
